// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/overlay.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tessera
{

/// Parts that are written as one geometry: firstPart .. endPart - 1.
struct OverlayLine
{
    std::size_t firstPart;
    std::size_t endPart;
};

/// The geometries of a result, in order: one for a union, intersection, difference or symmetric
/// difference, one for each owner with a priority, one for each cell; none for an empty result.
std::vector<OverlayLine> linesOf(const OverlayResult& result, BooleanOperation operation);

/// The result as well-known text, valid by OGC: a line for each of linesOf(), POLYGON or
/// MULTIPOLYGON; GEOMETRYCOLLECTION EMPTY for nothing. Numbers read back equal.
std::string formatWkt(const OverlayResult& result, BooleanOperation operation);

/// The outlines in Triangle's .poly format: every edge once, with its first curve's marker (if no
/// curve has one: 1 beside one part, 2 between two), a point in every hole, and for each part with
/// an owner or operands a region whose attribute is the owner's number, else the part's, from 1.
std::string formatPoly(const OverlayResult& result);

} // namespace tessera
