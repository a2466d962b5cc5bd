// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tessera
{

/// Why an input was refused or a run ended early.
enum class ErrorKind
{
    InvalidInput,  ///< not finite, out of range, ids that do not exist, not planar
    InvalidOption, ///< a size, angle, count or tolerance outside its range
    NoInside,      ///< no closed outline: nothing to mesh
    TooLarge,      ///< the result would not fit into memory; the message has the estimate
    Unreadable,    ///< a file that does not exist or is not in its format
    Unwritable,    ///< an output that could not be written
    Cancelled,     ///< the user or the caller asked to stop
    TimeLimit,     ///< the time limit ran out
};

/// What an error's places point at: lets a caller select the offending geometry.
struct ErrorPlace
{
    Vec2 position;
    std::uint32_t curve = 0xffffffffU; ///< index in the input's curves, or none
};

/// The only exception type that leaves the public functions of the core. The message is one
/// sentence that says what is wrong and what to do.
class Error: public std::runtime_error
{
public:
    Error(ErrorKind kind, const std::string& message, std::vector<ErrorPlace> places = {})
        : std::runtime_error(message)
        , kind_(kind)
        , places_(std::move(places))
    {}

    ErrorKind kind() const noexcept { return kind_; }
    const std::vector<ErrorPlace>& places() const noexcept { return places_; }

private:
    ErrorKind kind_;
    std::vector<ErrorPlace> places_;
};

} // namespace tessera
