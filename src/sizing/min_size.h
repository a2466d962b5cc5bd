// SPDX-License-Identifier: MIT
#pragma once

#include "sizing/size_field.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace tessera
{

/// The minimum of several fields: as steep as the steepest of them.
class MinSize final: public SizeField
{
public:
    /// Precondition: at least one field, none null.
    explicit MinSize(std::vector<std::shared_ptr<const SizeField>> fields)
        : fields_(std::move(fields))
    {}
    double size(Vec2 p) const override
    {
        double least = fields_.front()->size(p);
        for (std::size_t i = 1; i < fields_.size(); ++i) {
            least = std::min(least, fields_[i]->size(p));
        }
        return least;
    }
    double uniformSize() const override
    {
        double least = fields_.front()->uniformSize();
        for (const auto& field : fields_) {
            if (field->uniformSize() == 0.0) {
                return 0.0;
            }
            least = std::min(least, field->uniformSize());
        }
        return least;
    }
    double gradientBound() const override
    {
        double steepest = 0.0;
        for (const auto& field : fields_) {
            steepest = std::max(steepest, field->gradientBound());
        }
        return steepest;
    }

private:
    std::vector<std::shared_ptr<const SizeField>> fields_;
};

} // namespace tessera
