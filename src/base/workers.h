// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace tessera
{

/// Threads that wait for work: waking one costs less than starting one, above all on a busy machine.
/// They start when they are first needed and end with this object.
class Workers
{
public:
    Workers() = default;
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers()
    {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) {
            thread.join();
        }
    }

    /// Calls job here and, at the same time, on up to helpers of the threads; returns when all these
    /// calls have returned. A thread that wakes up later does nothing, so job must do all of the work
    /// however many calls there are. Preconditions: job throws nothing; no other call at the same
    /// time, not even from within job.
    void run(std::size_t helpers, const std::function<void()>& job)
    {
        {
            const std::lock_guard lock(mutex_);
            start(helpers);
            job_ = &job;
            wanted_ = helpers;
        }
        wake_.notify_all();
        job();
        std::unique_lock lock(mutex_);
        wanted_ = 0;
        done_.wait(lock, [this] { return running_ == 0; });
    }

private:
    void start(std::size_t count)
    {
        try {
            while (threads_.size() < count) {
                threads_.emplace_back([this] { work(); });
            }
        }
        catch (const std::system_error&) {
            // The system gives no more threads: those that there are do the work.
        }
    }

    void work()
    {
        std::unique_lock lock(mutex_);
        for (;;) {
            wake_.wait(lock, [this] { return ends_ || wanted_ > 0; });
            if (ends_) {
                return;
            }
            --wanted_;
            ++running_;
            const std::function<void()>& job = *job_;
            lock.unlock();
            job();
            lock.lock();
            if (--running_ == 0) {
                done_.notify_one();
            }
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable done_;
    std::vector<std::thread> threads_;
    const std::function<void()>* job_ = nullptr;
    std::size_t wanted_ = 0;  ///< threads that shall still take up the job
    std::size_t running_ = 0; ///< threads at it
    bool ends_ = false;
};

} // namespace tessera
