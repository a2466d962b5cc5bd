// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

namespace tessera
{

/// Target edge length h(p) > 0 everywhere. Thread-safe.
class SizeField
{
public:
    virtual ~SizeField() = default;
    virtual double size(Vec2 p) const = 0;
    /// The constant value if the field is uniform, else 0: refinement takes short cuts.
    virtual double uniformSize() const { return 0.0; }
    /// An upper bound of |grad h|; 0 if uniform.
    virtual double gradientBound() const = 0;
};

} // namespace tessera
