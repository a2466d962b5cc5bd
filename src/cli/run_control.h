// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"

namespace tessera::cli
{

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
