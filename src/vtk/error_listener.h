// SPDX-License-Identifier: MIT
#pragma once

#include <vtkCommand.h>

namespace tessera
{

/// Hears the errors of the VTK objects that it observes, which then print nothing.
class ErrorListener: public vtkCommand
{
public:
    static ErrorListener* New() { return new ErrorListener; }

    void Execute(vtkObject*, unsigned long event, void*) override
    {
        failed_ = failed_ || event == ErrorEvent;
    }
    bool failed() const { return failed_; }

private:
    bool failed_ = false;
};

} // namespace tessera
