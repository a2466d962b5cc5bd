// SPDX-License-Identifier: MIT
#include "cli/run_control.h"

#include <fmt/format.h>

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

namespace tessera::cli
{

namespace
{

std::atomic<Execution*> running {nullptr};
static_assert(std::atomic<Execution*>::is_always_lock_free, "used in a signal handler");

void cancelRun(int)
{
    if (Execution* execution = running.load()) {
        execution->cancel();
    }
}

} // namespace

RunControl::RunControl(Execution& execution, bool quiet)
    : execution_(execution)
    , begin_(Execution::Clock::now())
    , last_(begin_)
{
    running.store(&execution);
    std::signal(SIGINT, cancelRun);
    std::signal(SIGTERM, cancelRun);
    if (!quiet && isatty(STDERR_FILENO) != 0) {
        execution_.setProgress([this](double fraction, const char* stage) {
            show(fraction, stage);
        });
    }
}

RunControl::~RunControl()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    running.store(nullptr);
    execution_.setProgress({});
    if (shown_) {
        clearLine();
    }
}

void RunControl::show(double fraction, const char* stage)
{
    constexpr std::chrono::seconds kQuietFor {1};
    constexpr std::chrono::milliseconds kInterval {100};
    const auto now = Execution::Clock::now();
    if (now - begin_ < kQuietFor || now - last_ < kInterval) {
        return;
    }
    last_ = now;
    clearLine();
    fmt::print(stderr, "{:3.0f} % {}", 100.0 * fraction, stage);
    std::fflush(stderr);
    shown_ = true;
}

void RunControl::clearLine()
{
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
}

} // namespace tessera::cli
