// SPDX-License-Identifier: MIT

// Any bytes are an input: lines, arcs and polylines on a small grid, which touch, overlap and cross
// in every way, cut where they meet. The result must be a valid network whose curves are pieces of
// those of the input and start and end at their points.
//
// Byte 0: bit 0 whether straight curves are crossed, bit 1 whether points are welded. Then curves:
// a byte for the kind, then its numbers.

#include "bytes.h"

#include "arrange/arrange.h"
#include "base/error.h"
#include "curve/arc.h"
#include "curve/network_check.h"
#include "curve/polyline.h"

#include <memory>
#include <numbers>
#include <vector>

namespace tessera::fuzz
{
namespace
{

double coordinate(Bytes& bytes)
{
    const auto byte = bytes.take<std::uint8_t>();
    // Mostly a small grid; else a little beside it.
    return (byte & 15U) + ((byte >> 4) >= 12 ? 1e-7 * ((byte >> 4) - 11) : 0.0);
}

Vec2 point(Bytes& bytes)
{
    const double x = coordinate(bytes);
    return {x, coordinate(bytes)};
}

double angle(Bytes& bytes)
{
    return (bytes.take<std::uint8_t>() % 24) * std::numbers::pi / 12.0;
}

void addCurve(CurveNetwork& network, std::shared_ptr<const Curve> geometry)
{
    const PointId start = network.addPoint(geometry->point(geometry->first()));
    const PointId end = network.addPoint(geometry->point(geometry->last()));
    network.curves.push_back({std::move(geometry), start, end, OperandId(0U)});
}

CurveNetwork makeNetwork(Bytes& bytes)
{
    CurveNetwork network;
    network.operands.push_back({"fuzz"});
    while (!bytes.empty() && network.curves.size() < 12) {
        const auto kind = bytes.take<std::uint8_t>();
        const Vec2 p = point(bytes);
        if (kind % 4 < 2) {
            const PointId start = network.addPoint(p);
            const PointId end = network.addPoint(point(bytes));
            network.curves.push_back({nullptr, start, end, OperandId(0U)});
        }
        else if (kind % 4 == 2) {
            const double first = angle(bytes);
            const double span = angle(bytes) + std::numbers::pi / 12.0;
            const Vec2 u {coordinate(bytes) + 1.0, 0.0};
            const Vec2 v {0.0, (kind & 4) != 0 ? u.x : coordinate(bytes) + 1.0};
            addCurve(network, std::make_shared<EllipseArc>(p, u, v, first, first + span));
        }
        else {
            std::vector<Vec2> points {p};
            for (int i = 0; i < 1 + (kind >> 2) % 2; ++i) {
                points.push_back(point(bytes));
            }
            addCurve(network, std::make_shared<PolylineCurve>(points));
        }
    }
    return network;
}

void check(const CurveNetwork& network, const ArrangeOptions& options)
{
    Execution execution;
    ArrangeReport report;
    const CurveNetwork result = arrange(network, options, report, execution);
    for (const NetworkProblem& problem : findProblems(result)) {
        fail(problem.what);
    }
    require(report.parent.size() == result.curves.size(), "Not every curve has a parent.");
    require(report.firstCrossing <= result.points.size(), "There is no first crossing.");
    for (const CurveId parent : report.parent) {
        require(parent.index() < network.curves.size(), "A curve has a parent that is none.");
    }
    std::vector<bool> kept(network.curves.size());
    for (std::size_t c = 0; c < result.curves.size(); ++c) {
        kept[report.parent[c].index()] = true;
        const NetworkCurve& curve = result.curves[c];
        if (curve.geometry != nullptr) {
            const Curve& geometry = *curve.geometry;
            const double reach = 1e-3;
            require(distance(geometry.point(geometry.first()), result.points[curve.start.index()])
                            < reach
                        && distance(geometry.point(geometry.last()),
                                    result.points[curve.end.index()])
                            < reach,
                    "A curve does not end at its points.");
        }
    }
    for (const bool k : kept) {
        require(k, "A curve is lost.");
    }
}

} // namespace
} // namespace tessera::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera;
    fuzz::Bytes bytes(data, size);
    const auto head = bytes.take<std::uint8_t>();
    ArrangeOptions options;
    options.crossStraight = (head & 1) != 0;
    options.weld = (head & 2) != 0 ? 2e-7 : 0.0;
    try {
        fuzz::check(fuzz::makeNetwork(bytes), options);
    }
    catch (const Error& error) {
        if (error.kind() != ErrorKind::InvalidInput) {
            throw;
        }
    }
    return 0;
}
