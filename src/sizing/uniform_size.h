// SPDX-License-Identifier: MIT
#pragma once

#include "sizing/size_field.h"

namespace tessera
{

/// The same target length everywhere.
class UniformSize final: public SizeField
{
public:
    /// Precondition: size > 0 and finite.
    explicit UniformSize(double size)
        : size_(size)
    {}
    double size(Vec2) const override { return size_; }
    double uniformSize() const override { return size_; }
    double gradientBound() const override { return 0.0; }

private:
    double size_;
};

} // namespace tessera
