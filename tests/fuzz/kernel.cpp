// SPDX-License-Identifier: MIT

// Any bytes are an input: points and segments between them, triangulated, recovered by both
// strategies, verified and compared. The strategies must agree on whether the input is
// ill-conditioned, and on the mesh up to cocircular ties; where it is not, the vertices must be those
// of the input and the rounded crossings of all pairs; with small integers, as many as an exact
// count has. A finding is a property that does not hold, a sanitizer report or a hang.
//
// Byte 0: bits 0-2 the kind of coordinates (see coordinate()), bits 3-7 the number of points. Then
// the points, then segments as pairs of point numbers.

#include "coordinates.h"

#include "base/error.h"
#include "delaunay/delaunay.h"
#include "property/integer_arrangement.h"
#include "property/rounded_arrangement.h"
#include "property/same_mesh.h"
#include "recover/recover.h"

#include <vector>

namespace tessera::fuzz
{
namespace
{

test::RawPslg makePslg(Bytes& bytes, int kind, std::size_t pointCount)
{
    test::RawPslg raw;
    for (std::size_t i = 0; i < pointCount; ++i) {
        raw.addPoint(point(bytes, kind));
    }
    while (!bytes.empty() && raw.segments.size() < 64) {
        const std::size_t a = bytes.take<std::uint8_t>() % pointCount;
        raw.segments.emplace_back(a, bytes.take<std::uint8_t>() % pointCount);
    }
    return raw;
}

void requireNone(const std::vector<std::string>& problems)
{
    if (!problems.empty()) {
        fail(problems.front());
    }
}

RecoveryResult recover(const DelaunayResult& delaunay, const std::vector<ConstraintEnds>& ends,
                       RecoveryStrategy strategy)
{
    Execution execution;
    RecoveryResult result = recoverBoundaries(delaunay.triangulation, ends, strategy, execution);
    requireNone(verify(result.triangulation));
    requireNone(verifyConstraints(result, ends, delaunay.triangulation.points));
    const RecoveryReport& report = result.report;
    require(report.crossings == result.triangulation.points.size() - result.firstCrossing,
            "The crossings are not counted right.");
    require(strategy == RecoveryStrategy::Cavity
                || report.steinerInserted - report.steinerRemoved == report.crossings,
            "The Steiner points are not counted right.");
    require(report.maxDisplacement <= 0.75 * report.snapPixel || report.snapPixel == 0.0,
            "A point has moved out of its pixel.");
    return result;
}

void check(const test::RawPslg& raw, bool integers)
{
    Execution execution;
    const DelaunayResult delaunay = triangulate(raw.points, execution);
    requireNone(verify(delaunay.triangulation));
    std::vector<ConstraintEnds> ends;
    for (const auto& [a, b] : raw.segments) {
        ends.push_back({delaunay.vertexOfPoint[a], delaunay.vertexOfPoint[b]});
    }
    const RecoveryResult cavity = recover(delaunay, ends, RecoveryStrategy::Cavity);
    const RecoveryResult steiner = recover(delaunay, ends, RecoveryStrategy::Steiner);
    require(cavity.report.snapPixel == steiner.report.snapPixel,
            "The strategies disagree on the condition of the input.");
    const std::string difference
        = test::meshDifference(cavity.triangulation, steiner.triangulation);
    require(difference.empty(), difference.c_str());
    if (cavity.report.snapPixel == 0.0) {
        std::vector<Vec2> vertices(cavity.triangulation.points.begin() + 1,
                                   cavity.triangulation.points.end());
        test::sortUnique(vertices);
        require(vertices == test::roundedArrangement(raw),
                "Not the input and the rounded crossings.");
    }
    if (integers) {
        require(cavity.report.snapPixel == 0.0, "Integers are not ill-conditioned.");
        require(cavity.triangulation.vertexCount() == test::integerArrangement(raw).size(),
                "Not the vertices of the exact arrangement.");
    }
}

} // namespace
} // namespace tessera::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera::fuzz;
    Bytes bytes(data, size);
    const auto head = bytes.take<std::uint8_t>();
    try {
        check(makePslg(bytes, head & 7, 2U + (head >> 3)), (head & 7) == Integers);
    }
    catch (const tessera::Error& error) {
        if (error.kind() != tessera::ErrorKind::InvalidInput) {
            throw;
        }
    }
    return 0;
}
