// SPDX-License-Identifier: MIT
#pragma once

#include <vtkObject.h>

namespace tessera
{

/// While it lives, VTK prints no warnings and errors: ours say what the user needs.
class VtkSilence
{
public:
    VtkSilence()
        : before_(vtkObject::GetGlobalWarningDisplay())
    {
        vtkObject::GlobalWarningDisplayOff();
    }
    ~VtkSilence() { vtkObject::SetGlobalWarningDisplay(before_); }
    VtkSilence(const VtkSilence&) = delete;
    VtkSilence& operator=(const VtkSilence&) = delete;

private:
    vtkTypeBool before_;
};

} // namespace tessera
