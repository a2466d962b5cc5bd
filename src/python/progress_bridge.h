// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <utility>

namespace tessera::python
{

/// Brings progress from the running mesher to Python, at most every kInterval, and what Python says
/// (an exception of the callback or False, Ctrl-C) back as a cancellation.
class ProgressBridge
{
public:
    ProgressBridge(pybind11::object callback, Execution& execution)
        : callback_(std::move(callback))
        , execution_(execution)
    {
        execution.setProgress([this](double fraction, const char* stage) {
            const auto now = Execution::Clock::now();
            if (now - last_ >= kInterval) {
                last_ = now;
                tell(fraction, stage);
            }
        });
    }
    ~ProgressBridge() { execution_.setProgress({}); }
    ProgressBridge(const ProgressBridge&) = delete;
    ProgressBridge& operator=(const ProgressBridge&) = delete;

    /// GIL released on entry.
    void tell(double fraction, const char* stage)
    {
        const pybind11::gil_scoped_acquire acquire;
        try {
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
            if (!callback_.is_none()) {
                const pybind11::object answer = callback_(fraction, stage);
                if (answer.ptr() == Py_False) {
                    execution_.cancel();
                }
            }
        }
        catch (const pybind11::error_already_set&) {
            if (!failure_) {
                failure_ = std::current_exception();
            }
            execution_.cancel();
        }
    }

    /// What the callback raised, if anything. GIL held.
    void rethrow() const
    {
        if (failure_) {
            std::rethrow_exception(failure_);
        }
    }

private:
    static constexpr std::chrono::milliseconds kInterval {50};

    pybind11::object callback_;
    Execution& execution_;
    Execution::Clock::time_point last_ = Execution::Clock::now();
    std::exception_ptr failure_;
};

} // namespace tessera::python
