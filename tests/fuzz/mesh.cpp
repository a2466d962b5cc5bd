// SPDX-License-Identifier: MIT

// Any bytes are an input: a small drawing and options (see drawing.h), taken through the whole
// pipeline. It may be refused, by an Error of a kind that fits. Else:
// - the mesh is one that checkMesh() proves;
// - the points of straight drawings are nodes; boundaries that stay get no others; the regions and
//   each of the curves are as large and as long as without refining;
// - every angle and area that was asked for is reached or listed;
// - two threads make the same mesh; a run can be cancelled at any time.

#include "drawing.h"

#include "base/error.h"
#include "io/check_mesh.h"
#include "io/outline_check.h"
#include "predicates/predicates.h"

#include <limits>
#include <optional>
#include <set>

namespace tessera::fuzz
{
namespace
{

double greatest(const std::vector<Vec2>& points)
{
    double coordinate = 0.0;
    for (const Vec2 p : points) {
        coordinate = std::max({coordinate, std::fabs(p.x), std::fabs(p.y)});
    }
    return coordinate;
}

double leastHeight(const Mesh& mesh)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles) {
        const Vec2 a = mesh.nodes[t[0]];
        const Vec2 b = mesh.nodes[t[1]];
        const Vec2 c = mesh.nodes[t[2]];
        least = std::min(least, cross(b - a, c - a)
                             / std::max({distance(a, b), distance(b, c), distance(c, a)}));
    }
    return least;
}

/// Without mid nodes where there are places so narrow that rounded middles of sides can lie beyond.
RawMesh rawMesh(const Drawing& drawing, const Mesh& mesh)
{
    RawMesh raw;
    const bool second = drawing.roomy && mesh.order() == 2
        && leastHeight(mesh) > 64.0 * 0x1p-53 * greatest(mesh.nodes);
    for (const Vec2 p : mesh.nodes) {
        raw.nodeNumber.push_back(static_cast<std::int64_t>(raw.nodes.size()));
        raw.nodes.push_back({p.x, p.y, 0.0});
    }
    const auto add = [&raw](CellKind kind, const std::vector<std::uint32_t>& nodes) {
        raw.cells.push_back({kind, static_cast<std::uint32_t>(raw.cellNodes.size()),
                             static_cast<std::int64_t>(raw.cells.size())});
        raw.cellNodes.insert(raw.cellNodes.end(), nodes.begin(), nodes.end());
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        if (!second) {
            add(CellKind::Triangle3, {v[0], v[1], v[2]});
        }
        else {
            const auto& m = mesh.triangleMidNodes[t];
            add(CellKind::Triangle6, {v[0], v[1], v[2], m[2], m[0], m[1]});
        }
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        const auto& v = mesh.edges[e];
        if (!second) {
            add(CellKind::Edge2, {v[0], v[1]});
        }
        else {
            add(CellKind::Edge3, {v[0], v[1], mesh.edgeMidNodes[e]});
        }
    }
    return raw;
}

/// The outline crosses nothing and covers nothing twice, exactly.
void requireOutline(const Mesh& mesh)
{
    std::set<OutlineSide> open;
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i];
            const std::uint32_t b = t[(i + 1) % 3];
            if (open.erase({b, a}) == 0) {
                open.insert({a, b});
            }
        }
    }
    const std::vector<OutlineSide> outline(open.begin(), open.end());
    require(sweepOutline(mesh.nodes, outline).empty(), "Triangles overlap.");
}

void requireValid(const Drawing& drawing, const MeshResult& made)
{
    if (made.mesh.triangles.empty()) {
        return; // all or the hull of nothing
    }
    for (const std::string& problem : checkMesh(rawMesh(drawing, made.mesh)).problems) {
        // Nodes as near to a side as rounding could have put them are where they should be.
        if (drawing.roomy || problem.find(" hangs on ") == std::string::npos) {
            fail(problem);
        }
    }
    requireOutline(made.mesh);
    require(made.mesh.triangleRegion.size() == made.mesh.triangles.size(),
            "Not every triangle has a region.");
    for (const std::uint32_t region : made.mesh.triangleRegion) {
        require(region < made.mesh.regions.size(), "A triangle's region is none.");
    }
}

/// But for crossings and welds, which move points, a point of the drawing is a node, or outside.
void requirePoints(const Drawing& drawing, const MeshResult& made)
{
    std::vector<Vec2> wanted;
    for (const NetworkCurve& curve : drawing.network.curves) {
        if (isMeshed(curve)) {
            wanted.push_back(drawing.network.points[curve.start.index()]);
            wanted.push_back(drawing.network.points[curve.end.index()]);
        }
    }
    for (const EmbeddedPoint& embedded : drawing.network.embedded) {
        wanted.push_back(drawing.network.points[embedded.point.index()]);
    }
    for (const Vec2 p : wanted) {
        for (const auto& t : made.mesh.triangles) {
            const Vec2 a = made.mesh.nodes[t[0]];
            const Vec2 b = made.mesh.nodes[t[1]];
            const Vec2 c = made.mesh.nodes[t[2]];
            require(p == a || p == b || p == c || orient2d(a, b, p) < 0 || orient2d(b, c, p) < 0
                        || orient2d(c, a, p) < 0,
                    "A point of the drawing lies in a triangle.");
        }
    }
}

void requireListed(const Drawing& drawing, const MeshResult& made)
{
    const MeshOptions& options = drawing.options;
    const double rounding = 1e-12 * greatest(drawing.network.points);
    for (const auto& t : made.mesh.triangles) {
        const Vec2 a = made.mesh.nodes[t[0]];
        const Vec2 b = made.mesh.nodes[t[1]];
        const Vec2 c = made.mesh.nodes[t[2]];
        const Vec2 center = (1.0 / 3.0) * (a + b + c);
        const auto isListed = [&](const char* what) {
            return std::ranges::any_of(made.report.unreached, [&](const Unreached& item) {
                return item.what == what && distance(item.place, center) <= rounding;
            });
        };
        constexpr double kNear = 1e-6;
        require(triangleAngles(a, b, c).smallest > options.minAngle - kNear || isListed("min_angle"),
                "An angle is below the wanted one and not listed.");
        require(options.maxArea == 0.0
                    || 0.5 * cross(b - a, c - a) < options.maxArea * (1.0 + kNear)
                    || isListed("max_area"),
                "An area is above the wanted one and not listed.");
    }
}

/// By curve of the drawing: the length of the edges on it.
std::vector<double> curveLengths(const Drawing& drawing, const Mesh& mesh)
{
    std::vector<double> lengths(drawing.network.curves.size());
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        for (std::uint32_t i = mesh.edgeCurveStart[e]; i < mesh.edgeCurveStart[e + 1]; ++i) {
            lengths.at(mesh.edgeCurves[i].index()) +=
                distance(mesh.nodes[mesh.edges[e][0]], mesh.nodes[mesh.edges[e][1]]);
        }
    }
    return lengths;
}

bool isNear(double x, double y, double rounding)
{
    return std::fabs(x - y) <= 1e-9 * std::max(x, y) + rounding;
}

/// The triangles of the straight lines alone have the same topology and, but for rounding, measures.
void requireSameDomain(const Drawing& drawing, const MeshResult& made, const MeshResult& plain)
{
    const double rounding = 1e-10 * greatest(drawing.network.points);
    if (drawing.options.order == 1) {
        double area = 0.0;
        for (const auto& t : made.mesh.triangles) {
            const Vec2 a = made.mesh.nodes[t[0]];
            area += 0.5 * cross(made.mesh.nodes[t[1]] - a, made.mesh.nodes[t[2]] - a);
        }
        require(isNear(area, made.report.area, 0.0), "The area is not that of the triangles.");
    }
    require(isNear(made.report.area, plain.report.area,
                   rounding * greatest(drawing.network.points)),
            "Refining changes the area.");
    if (!drawing.roomy) {
        return; // a curve beside a boundary can be on either side of it
    }
    const std::vector<double> lengths = curveLengths(drawing, made.mesh);
    const std::vector<double> plainLengths = curveLengths(drawing, plain.mesh);
    for (std::size_t c = 0; c < lengths.size(); ++c) {
        require(isNear(lengths[c], plainLengths[c], rounding), "Refining changes a curve.");
    }
    require(!drawing.options.freezeBoundary || made.mesh.edges.size() == plain.mesh.edges.size(),
            "A boundary is divided that should stay.");
}

void requireSame(const Mesh& made, const Mesh& again)
{
    require(made.nodes == again.nodes && made.triangles == again.triangles
                && made.edges == again.edges && made.edgeCurves == again.edgeCurves
                && made.triangleMidNodes == again.triangleMidNodes,
            "A second run makes another mesh.");
}

/// Empty if it was refused or cancelled.
std::optional<MeshResult> meshed(const Drawing& drawing, const MeshOptions& options,
                                 Execution& execution)
{
    try {
        MeshResult made = meshNetwork(drawing.network, options, execution);
        requireValid(drawing, made);
        return made;
    }
    catch (const Error& error) {
        const ErrorKind kind = error.kind();
        require(kind == ErrorKind::InvalidInput || kind == ErrorKind::InvalidOption
                    || kind == ErrorKind::NoInside || kind == ErrorKind::TooLarge
                    || (kind == ErrorKind::Cancelled && drawing.cancelAfter > 0),
                "An error of a kind that does not fit.");
        return std::nullopt;
    }
}

void checkSecondRun(const Drawing& drawing, const MeshResult& made)
{
    Execution execution;
    execution.setThreads(drawing.twoThreads ? 2 : 1);
    int told = 0;
    execution.setProgress([&](double, const char*) {
        if (++told == drawing.cancelAfter) {
            execution.cancel();
        }
    });
    const auto again = meshed(drawing, drawing.options, execution);
    require(again || drawing.cancelAfter > 0, "A second run is refused.");
    if (again) {
        requireSame(made.mesh, again->mesh);
    }
}

void check(const Drawing& drawing)
{
    Execution execution;
    const auto made = meshed(drawing, drawing.options, execution);
    if (!made) {
        return;
    }
    requireListed(drawing, *made);
    const RecoveryReport& recovery = made->report.recovery;
    if (drawing.straight && drawing.options.weld < 0.0 && recovery.snapPixel == 0.0) {
        requirePoints(drawing, *made);
        MeshOptions plainOptions = drawing.options;
        plainOptions.refine = false;
        plainOptions.count = 0;
        plainOptions.size = 0.0;
        const auto plain = meshed(drawing, plainOptions, execution);
        require(plain.has_value(), "Without refining, the drawing is refused.");
        if (plain->report.recovery.snapPixel == 0.0) {
            requireSameDomain(drawing, *made, *plain);
        }
    }
    if (drawing.twoThreads || drawing.cancelAfter > 0) {
        checkSecondRun(drawing, *made);
    }
}

} // namespace
} // namespace tessera::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera;
    std::optional<fuzz::Drawing> drawing;
    try {
        drawing = fuzz::DrawingMaker(data, size).make();
    }
    catch (const Error&) {
        return 0; // a curve with values that are not finite
    }
    fuzz::check(*drawing);
    return 0;
}
