// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"

namespace tessera::cli
{

/// Time since the start of the command, for the stages outside the pipeline.
class CommandClock
{
public:
    double seconds() const
    {
        return std::chrono::duration<double>(Execution::Clock::now() - begin_).count();
    }

private:
    Execution::Clock::time_point begin_ = Execution::Clock::now();
};

/// While it lives, Ctrl-C and SIGTERM cancel the run, and a run of more than a second shows its
/// progress on stderr if that is a terminal. One at a time.
class RunControl
{
public:
    explicit RunControl(Execution& execution, bool quiet);
    ~RunControl();
    RunControl(const RunControl&) = delete;
    RunControl& operator=(const RunControl&) = delete;

private:
    void show(double fraction, const char* stage);
    void clearLine();

    Execution& execution_;
    Execution::Clock::time_point begin_;
    Execution::Clock::time_point last_;
    bool shown_ = false;
};

} // namespace tessera::cli
