// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "base/workers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <thread>

namespace tessera
{

/// Progress, cancel, time limit and threads of one run; passed by reference to every long stage.
/// Stages call checkpoint() at least every few milliseconds of work. Thread-safe.
class Execution
{
public:
    using Clock = std::chrono::steady_clock;
    /// Called with the overall fraction 0..1 (never falling) and the stage's name.
    using Progress = std::function<void(double fraction, const char* stage)>;

    Execution() = default;
    Execution(const Execution&) = delete;
    Execution& operator=(const Execution&) = delete;

    void setProgress(Progress progress) { progress_ = std::move(progress); }
    void setTimeLimit(double seconds)
    {
        constexpr double kForever = 1e9; // the clock cannot count much farther
        seconds = std::min(seconds, kForever);
        deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                        std::chrono::duration<double>(seconds));
    }
    /// How many threads stages may use; 0: as many as the machine has. Results do not depend on it.
    void setThreads(int count)
    {
        const auto all = static_cast<int>(std::thread::hardware_concurrency());
        threads_ = std::max(count > 0 ? count : all, 1);
    }
    int threads() const { return threads_; }
    /// For base/parallel.h.
    Workers& workers() const { return workers_; }
    void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }

    /// Where several runs make up the whole: the stages of the next one fill [begin, end] of it.
    void setShare(double begin, double end)
    {
        shareBegin_ = begin;
        shareEnd_ = end;
    }
    /// A stage covers [begin, end] of its run; its own progress is scaled into it.
    void beginStage(const char* name, double begin, double end)
    {
        stage_ = name;
        begin_ = shareBegin_ + (shareEnd_ - shareBegin_) * begin;
        end_ = shareBegin_ + (shareEnd_ - shareBegin_) * end;
        report(0.0);
    }
    /// Throws Error(Cancelled) or Error(TimeLimit). Cheap without a time limit.
    void checkpoint() const
    {
        if (cancelled_.load(std::memory_order_relaxed)) {
            throw Error(ErrorKind::Cancelled, "Cancelled.");
        }
        if (deadline_ && Clock::now() > *deadline_) {
            throw Error(ErrorKind::TimeLimit, "The time limit ran out; raise it.");
        }
    }
    /// checkpoint() and tell how much of the stage is done, 0..1.
    void report(double fraction)
    {
        checkpoint();
        if (progress_) {
            const double overall = begin_ + (end_ - begin_) * fraction;
            if (overall >= last_) {
                last_ = overall;
                progress_(overall, stage_);
            }
        }
    }

private:
    std::atomic<bool> cancelled_ {false};
    std::optional<Clock::time_point> deadline_;
    int threads_ = 1;
    mutable Workers workers_;
    Progress progress_;
    const char* stage_ = "";
    double shareBegin_ = 0.0;
    double shareEnd_ = 1.0;
    double begin_ = 0.0;
    double end_ = 1.0;
    double last_ = 0.0;
};

} // namespace tessera
