// SPDX-License-Identifier: MIT
#include "io/stage_pictures.h"

#include "io/atomic_file.h"
#include "io/drawing.h"
#include "io/mesh_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

namespace tessera
{

namespace
{

constexpr Color kWire {0.56, 0.64, 0.72};
constexpr Color kFaintWire {0.82, 0.86, 0.90};
constexpr Color kRectangle {0.20, 0.45, 0.62};
constexpr Color kBoundary {0.08, 0.13, 0.24};
constexpr Color kMissing {0.83, 0.15, 0.12};
constexpr Color kPoint {0.12, 0.26, 0.45};
constexpr double kWireFrom = 14.0; ///< pixels of an edge from which on it has its full width

std::string counted(std::size_t count, const char* one, const char* many)
{
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// The finite triangles; classOf(t) is a class or kNone to leave the triangle out.
template<class ClassOf>
DrawnTriangles drawnTriangles(const Triangulation& triangulation, ClassOf&& classOf)
{
    DrawnTriangles drawn;
    drawn.points = triangulation.points;
    for (std::uint32_t t = 0; t < triangulation.triangles.size(); ++t) {
        const std::uint32_t c = triangulation.isFinite(t) ? classOf(t) : DrawnTriangles::kNone;
        if (c != DrawnTriangles::kNone) {
            const auto& v = triangulation.triangles[t].v;
            drawn.corners.push_back({v[0], v[1], v[2]});
            drawn.classOf.push_back(c);
        }
    }
    return drawn;
}

DrawnTriangles allTriangles(const Triangulation& triangulation)
{
    return drawnTriangles(triangulation, [](std::uint32_t) { return 0U; });
}

/// Dots for all vertices, smaller the more there are.
void drawPoints(Canvas& canvas, std::span<const Vec2> points, std::size_t count)
{
    const double radius = std::clamp(160.0 / std::sqrt(static_cast<double>(count) + 1.0), 0.6, 6.0);
    for (std::size_t v = 1; v <= count; ++v) {
        canvas.dot(points[v], radius, kPoint);
    }
}

/// The edges on constraints as the recovery left them.
std::vector<DrawnEdge> subsegments(const RecoveryResult& result)
{
    std::vector<DrawnEdge> edges;
    for (const Subsegment& s : result.constraints.subsegments) {
        edges.push_back({s.a, s.b});
    }
    return edges;
}

/// A window a fifth as wide as the domain, where the constraints lie densest.
Box2 zoomWindow(const Mesh& mesh)
{
    constexpr std::size_t kCells = 5;
    const Box2 box = boundsOf(mesh);
    const double side = std::max(box.max.x - box.min.x, box.max.y - box.min.y) / kCells;
    if (!(side > 0.0)) {
        return box;
    }
    // Windows at half steps; the one with the most constraint edges, then nearest to the middle.
    std::array<std::size_t, 4 * kCells * kCells> count {};
    constexpr std::size_t kSteps = 2 * kCells;
    for (const auto& edge : mesh.edges) {
        const Vec2 m = midpoint(mesh.nodes[edge[0]], mesh.nodes[edge[1]]);
        const auto column = static_cast<std::size_t>(2.0 * (m.x - box.min.x) / side);
        const auto row = static_cast<std::size_t>(2.0 * (m.y - box.min.y) / side);
        ++count[std::min(row, kSteps - 1) * kSteps + std::min(column, kSteps - 1)];
    }
    std::size_t most = 0;
    double nearest = std::numeric_limits<double>::infinity();
    Box2 best = box;
    for (std::size_t row = 0; row + 1 < kSteps; ++row) {
        for (std::size_t column = 0; column + 1 < kSteps; ++column) {
            const std::size_t at = row * kSteps + column;
            const std::size_t sum =
                count[at] + count[at + 1] + count[at + kSteps] + count[at + kSteps + 1];
            const Vec2 low = box.min
                + Vec2 {0.5 * side * static_cast<double>(column),
                        0.5 * side * static_cast<double>(row)};
            const Box2 window {low, low + Vec2 {side, side}};
            const double away = distance(window.center(), box.center());
            if (sum > most || (sum == most && away < nearest)) {
                most = sum;
                nearest = away;
                best = window;
            }
        }
    }
    return best;
}

Box2 boundsOf(const Triangulation& triangulation)
{
    Box2 box;
    for (std::size_t v = 1; v < triangulation.points.size(); ++v) {
        box.add(triangulation.points[v]);
    }
    return box;
}

/// Adds the time of a scope to a sum.
class DrawingTime
{
public:
    explicit DrawingTime(double& sum)
        : sum_(sum)
    {}
    ~DrawingTime() { sum_ += std::chrono::duration<double>(Clock::now() - begin_).count(); }
    DrawingTime(const DrawingTime&) = delete;
    DrawingTime& operator=(const DrawingTime&) = delete;

private:
    using Clock = std::chrono::steady_clock;

    double& sum_;
    Clock::time_point begin_ = Clock::now();
};

} // namespace

StagePictures::StagePictures(std::filesystem::path folder)
    : folder_(std::move(folder))
{
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error || !std::filesystem::is_directory(folder_, error)) {
        throw Error(ErrorKind::Unwritable,
                    fmt::format("{}: the folder for the pictures cannot be made.",
                                folder_.string()));
    }
}

void StagePictures::save(const std::string& name, const Box2& view, const std::string& caption,
                         const std::function<void(Canvas&)>& draw)
{
    for (const PictureFormat format : {PictureFormat::Svg, PictureFormat::Png}) {
        Canvas canvas(view, format, caption);
        draw(canvas);
        AtomicFile file(folder_ / (name + (format == PictureFormat::Svg ? ".svg" : ".png")));
        file.write(canvas.finish());
        file.commit();
    }
}

void StagePictures::initialRectangle(const InitialRectangle& rectangle)
{
    rectangle_ = rectangle;
}

void StagePictures::pointsInserted(const Triangulation& triangulation,
                                   const InitialRectangle& rectangle)
{
    const DrawingTime time(seconds_);
    const std::size_t count = triangulation.vertexCount();
    domain_ = boundsOf(triangulation);
    Box2 view;
    for (Vec2 corner : rectangle.corner) {
        view.add(corner);
    }
    save("1-rectangle", view, "The initial triangulated rectangle around the points to insert",
         [&](Canvas& canvas) {
             drawPoints(canvas, triangulation.points, count);
             for (const auto& triangle : rectangle.triangle) {
                 for (std::size_t i = 0; i < 3; ++i) {
                     canvas.line(rectangle.corner[triangle[i]],
                                 rectangle.corner[triangle[(i + 1) % 3]], 3.0, kRectangle);
                 }
             }
         });

    Triangulation complete = triangulation;
    completeToRectangle(complete, rectangle);
    const DrawnTriangles drawn = allTriangles(complete);
    const std::vector<DrawnEdge> sides = sidesOf(drawn);
    save("2-points", view,
         fmt::format("{} inserted by Bowyer-Watson", counted(count, "point", "points")),
         [&](Canvas& canvas) {
             strokeEdges(canvas, complete.points, sides, {kWire, 1.6, kWireFrom, 0.12});
             drawPoints(canvas, triangulation.points, count);
         });
}

void StagePictures::beforeRecovery(const Triangulation& triangulation,
                                   std::span<const ConstraintEnds> constraints)
{
    const DrawingTime time(seconds_);
    std::vector<DrawnEdge> present;
    std::vector<DrawnEdge> missing;
    for (const ConstraintEnds& ends : constraints) {
        if (ends.a != ends.b) {
            const bool there = triangulation.findEdge(ends.a, ends.b) != Topology::kDead;
            (there ? present : missing).push_back({ends.a, ends.b});
        }
    }
    drawsRecovery_ = domain_.empty() || missing.size() >= mostMissing_;
    if (!drawsRecovery_) {
        return;
    }
    mostMissing_ = missing.size();
    domain_ = boundsOf(triangulation);
    const DrawnTriangles drawn = allTriangles(triangulation);
    const std::vector<DrawnEdge> sides = sidesOf(drawn);
    save("3-before-recovery", domain_,
         fmt::format("Before boundary recovery: {} of {} missing",
                     missing.empty() ? "none" : fmt::format("{} (red)", missing.size()),
                     counted(constraints.size(), "boundary segment", "boundary segments")),
         [&](Canvas& canvas) {
             const auto& points = triangulation.points;
             strokeEdges(canvas, points, sides, {kWire, 1.3, kWireFrom, 0.12});
             strokeEdges(canvas, points, present, {kBoundary, 2.8, 10.0, 0.9});
             for (const DrawnEdge& edge : missing) {
                 canvas.line(points[edge.a], points[edge.b], 2.8, kMissing, true);
             }
         });
}

void StagePictures::steinerInserted(const Triangulation& triangulation, std::uint32_t vertex)
{
    const DrawingTime time(seconds_);
    steiner_.steinerInserted(triangulation, vertex);
}

void StagePictures::steinerRemoved(const Triangulation& triangulation, std::uint32_t formerVertex)
{
    const DrawingTime time(seconds_);
    steiner_.steinerRemoved(triangulation, formerVertex);
}

void StagePictures::recovered(const RecoveryResult& result)
{
    const DrawingTime time(seconds_);
    if (steiner_.available()) {
        save("steiner-before", steiner_.view(),
             "Steiner point G where a boundary crosses a mesh edge, and its cavity",
             [this](Canvas& canvas) { steiner_.drawBefore(canvas); });
        save("steiner-after", steiner_.view(),
             "G deleted: the cavity is split along the boundary and both parts re-meshed",
             [this](Canvas& canvas) { steiner_.drawAfter(canvas); });
    }
    if (!drawsRecovery_) {
        return;
    }
    const Triangulation& triangulation = result.triangulation;
    const DrawnTriangles drawn = allTriangles(triangulation);
    const std::vector<DrawnEdge> sides = sidesOf(drawn);
    const std::vector<DrawnEdge> boundaries = subsegments(result);
    const std::size_t made = result.report.crossings;
    save("4-recovered", domain_,
         fmt::format("After boundary recovery: {} of the triangulation lie on boundaries{}",
                     counted(boundaries.size(), "edge", "edges"),
                     made == 0 ? std::string()
                               : ", " + counted(made, "crossing", "crossings") + " (red)"),
         [&](Canvas& canvas) {
             strokeEdges(canvas, triangulation.points, sides, {kWire, 1.3, kWireFrom, 0.12});
             strokeEdges(canvas, triangulation.points, boundaries, {kBoundary, 2.8, 10.0, 0.9});
             for (std::size_t v = result.firstCrossing; v < triangulation.points.size(); ++v) {
                 if (triangulation.incident[v] != Topology::kDead) {
                     canvas.dot(triangulation.points[v], 6.0, kMissing);
                 }
             }
         });
}

void StagePictures::outsideRemoved(const RecoveryResult& result, const RegionMap& regions)
{
    const DrawingTime time(seconds_);
    const Triangulation& triangulation = result.triangulation;
    const auto isKept = [&](std::uint32_t t) {
        const RegionId region = regions.regionOfTriangle[t];
        return region.valid() && regions.regions[region.index()].inside;
    };
    // Numbered as the mesh's regions will be, so that they have the same colors.
    std::vector<std::uint32_t> number(regions.regions.size(), 0);
    std::uint32_t keptCount = 0;
    for (std::size_t r = 0; r < number.size(); ++r) {
        number[r] = regions.regions[r].inside ? keptCount++ : 0;
    }
    const DrawnTriangles kept = drawnTriangles(triangulation, [&](std::uint32_t t) {
        return isKept(t) ? number[regions.regionOfTriangle[t].index()] : DrawnTriangles::kNone;
    });
    const DrawnTriangles removed = drawnTriangles(triangulation, [&](std::uint32_t t) {
        return isKept(t) ? DrawnTriangles::kNone : 0U;
    });
    const std::vector<DrawnEdge> sides = sidesOf(kept);
    const std::vector<DrawnEdge> removedSides = sidesOf(removed);
    save("5-outside-removed", domain_,
         fmt::format("Outside removed: {} in {}",
                     counted(kept.corners.size(), "triangle", "triangles"),
                     counted(regions.keptRegions, "region", "regions")),
         [&](Canvas& canvas) {
             const auto& points = triangulation.points;
             fillClasses(canvas, points, sides, chooseColors(sides, keptCount));
             strokeEdges(canvas, points, removedSides, {kFaintWire, 1.0, kWireFrom, 0.12});
             strokeEdges(canvas, points, sides, {kWire, 1.3, kWireFrom, 0.12});
             strokeEdges(canvas, points, subsegments(result), {kBoundary, 2.8, 10.0, 0.9});
         });
}

void StagePictures::optimized(const Mesh& mesh)
{
    const DrawingTime time(seconds_);
    const Box2 view = boundsOf(mesh);
    save("6-optimized", view,
         fmt::format("The mesh: {}", counted(mesh.triangles.size(), "triangle", "triangles")),
         [&](Canvas& canvas) { drawMesh(canvas, mesh); });
    save("7-zoom", zoomWindow(mesh), "A part of the mesh, enlarged",
         [&](Canvas& canvas) { drawMesh(canvas, mesh); });
}

} // namespace tessera
