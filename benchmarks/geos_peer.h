// SPDX-License-Identifier: MIT
#pragma once

// GEOS through its C interface, for comparisons.

#include "base/vec2.h"

#include <geos_c.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace tessera::bench
{

using GeosGeometry = std::shared_ptr<GEOSGeometry>;

inline GEOSContextHandle_t geosContext()
{
    static const GEOSContextHandle_t context = GEOS_init_r();
    return context;
}

/// Takes ownership of what GEOS returned; empty if it failed.
inline GeosGeometry geosOwned(GEOSGeometry* geometry)
{
    return {geometry, [](GEOSGeometry* g) { GEOSGeom_destroy_r(geosContext(), g); }};
}

inline GeosGeometry geosCollection(int type, std::vector<GEOSGeometry*> parts)
{
    return geosOwned(GEOSGeom_createCollection_r(geosContext(), type, parts.data(),
                                                 static_cast<unsigned>(parts.size())));
}

inline GeosGeometry geosPoints(std::span<const Vec2> points)
{
    std::vector<GEOSGeometry*> parts;
    for (const Vec2 p : points) {
        parts.push_back(GEOSGeom_createPointFromXY_r(geosContext(), p.x, p.y));
    }
    return geosCollection(GEOS_MULTIPOINT, std::move(parts));
}

inline GeosGeometry geosLines(std::span<const Vec2> points,
                              std::span<const std::pair<std::uint32_t, std::uint32_t>> segments)
{
    std::vector<GEOSGeometry*> parts;
    for (const auto& [a, b] : segments) {
        GEOSCoordSequence* ends = GEOSCoordSeq_create_r(geosContext(), 2, 2);
        GEOSCoordSeq_setXY_r(geosContext(), ends, 0, points[a].x, points[a].y);
        GEOSCoordSeq_setXY_r(geosContext(), ends, 1, points[b].x, points[b].y);
        parts.push_back(GEOSGeom_createLineString_r(geosContext(), ends));
    }
    return geosCollection(GEOS_MULTILINESTRING, std::move(parts));
}

/// The closed ring through the points; the caller owns it.
inline GEOSGeometry* geosRing(std::span<const Vec2> points)
{
    const auto count = static_cast<unsigned>(points.size() + 1);
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geosContext(), count, 2);
    for (unsigned i = 0; i < count; ++i) {
        const Vec2 p = points[i % points.size()];
        GEOSCoordSeq_setXY_r(geosContext(), sequence, i, p.x, p.y);
    }
    return GEOSGeom_createLinearRing_r(geosContext(), sequence);
}

/// The triangles as polygons.
inline GeosGeometry geosDelaunay(const GeosGeometry& points)
{
    return geosOwned(GEOSDelaunayTriangulation_r(geosContext(), points.get(), 0.0, 0));
}

/// Lines split where they cross (OverlayNG): pieces only, no triangles.
inline GeosGeometry geosNoding(const GeosGeometry& lines)
{
    return geosOwned(GEOSUnaryUnion_r(geosContext(), lines.get()));
}

} // namespace tessera::bench
