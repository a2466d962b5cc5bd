// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"
#include "sizing/area_size.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tessera
{

/// Triangles with a size at each node.
struct BackgroundMesh
{
    std::string name; ///< for messages: "sizes.vtu"
    std::vector<Vec2> nodes;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< either orientation
    std::vector<double> sizes;                           ///< by node, > 0
};

/// The sizes interpolated linearly within the triangles; outside of them, the size at the nearest
/// point of one. Throws Error(InvalidOption) if there is no triangle or one without area, if
/// an index or a size is wrong: with the node's place.
AreaSource backgroundSource(BackgroundMesh mesh);

} // namespace tessera
