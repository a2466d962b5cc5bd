// SPDX-License-Identifier: MIT
#include "region/colored_plane.h"

#include "base/error.h"
#include "base/number_text.h"
#include "curve/curve_tools.h"
#include "delaunay/delaunay.h"
#include "recover/recover.h"
#include "sample/sample.h"
#include "sizing/uniform_size.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tessera
{

namespace
{

constexpr double kPiecesPerTurn = 48.0;

[[noreturn]] void refuse(const std::string& text, std::vector<ErrorPlace> places = {})
{
    throw Error(ErrorKind::InvalidOption, text, std::move(places));
}

std::vector<ConstraintEnds> endsOf(const Pslg& pslg, const std::vector<std::uint32_t>& vertexOf)
{
    std::vector<ConstraintEnds> ends;
    ends.reserve(pslg.segments.size());
    for (const PslgSegment& segment : pslg.segments) {
        ends.push_back({vertexOf[segment.a.index()], vertexOf[segment.b.index()]});
    }
    return ends;
}

} // namespace

ColoredPlane::ColoredPlane(const CurveNetwork& network, FillRule fill, Execution& execution)
    : operands_(network.operands.size())
{
    const double extent = networkBounds(network).diagonal();
    const UniformSize whole(extent > 0.0 ? extent : 1.0);
    const SampleOptions options {.straightSegments = false, .piecesPerTurn = kPiecesPerTurn};
    const Pslg pslg = sample(network, whole, options, execution);
    DelaunayResult delaunay = triangulate(pslg.points, execution);
    const auto ends = endsOf(pslg, delaunay.vertexOfPoint);
    RecoveryResult recovered = recoverBoundaries(std::move(delaunay.triangulation), ends,
                                                 RecoveryStrategy::Cavity, execution);
    regions_ = colorRegions(recovered, network, pslg, fill, execution);
    triangulation_ = std::move(recovered.triangulation);
    for (std::uint32_t t = 0; t < triangulation_.triangles.size(); ++t) {
        if (triangulation_.isFinite(t)) {
            hint_ = Topology::halfEdge(t, 0);
            break;
        }
    }
}

std::size_t ColoredPlane::regionIndexAt(Vec2 p) const
{
    if (triangulation_.triangles.empty()) {
        return 0;
    }
    hint_ = locate(triangulation_, p, hint_).edge;
    const RegionId region = regions_.regionOfTriangle[Topology::triangleOf(hint_)];
    return region.valid() ? region.index() : 0;
}

AreaSource ColoredPlane::areaSource(const RegionSize& region) const
{
    char text[200];
    if (!(region.size > 0.0) || !std::isfinite(region.size)) {
        std::snprintf(text, sizeof text,
                      "The size of a region is %.6g; it must be a number above 0.", region.size);
        refuse(text);
    }
    std::vector<std::uint8_t> chosen(regions_.regions.size(), 0);
    if (region.operand.valid()) {
        if (region.operand.index() >= operands_) {
            std::snprintf(text, sizeof text,
                          "A size is for operand %zu, but there are only %zu, counted from 1.",
                          region.operand.index() + 1, operands_);
            refuse(text);
        }
        for (std::size_t r = 0; r < chosen.size(); ++r) {
            const std::vector<OperandId>& covering = regions_.regions[r].operands;
            chosen[r] = std::binary_search(covering.begin(), covering.end(), region.operand) ? 1 : 0;
        }
        if (std::find(chosen.begin(), chosen.end(), 1) == chosen.end()) {
            std::snprintf(text, sizeof text,
                          "A size is for the inside of operand %zu, which encloses nothing; give "
                          "its curves a size instead.",
                          region.operand.index() + 1);
            refuse(text);
        }
    }
    else {
        const std::size_t found = isFinite(region.position) ? regionIndexAt(region.position) : 0;
        if (!regions_.regions[found].inside) {
            refuse("A size is for the region around " + placeText(region.position)
                       + ", but that place is not inside; choose one between the curves.",
                   {{region.position}});
        }
        chosen[found] = 1;
    }
    constexpr double kNone = std::numeric_limits<double>::infinity();
    return {"The size of a region",
            [this, chosen, size = region.size](Vec2 p) {
                return chosen[regionIndexAt(p)] != 0 ? size : kNone;
            },
            false};
}

} // namespace tessera
