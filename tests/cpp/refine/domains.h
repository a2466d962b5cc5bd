// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve.h"
#include "delaunay/delaunay.h"
#include "recover/recover.h"
#include "refine/refine.h"
#include "sizing/size_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace tessera::test
{

struct UniformSize: SizeField
{
    explicit UniformSize(double h)
        : h_(h)
    {}
    double size(Vec2) const override { return h_; }
    double uniformSize() const override { return h_; }
    double gradientBound() const override { return 0.0; }

private:
    double h_;
};

/// h = h0 + g × distance to the segment a-b, at most hMax.
struct SegmentSize: SizeField
{
    SegmentSize(Vec2 a, Vec2 b, double h0, double g, double hMax)
        : a_(a)
        , b_(b)
        , h0_(h0)
        , g_(g)
        , hMax_(hMax)
    {}
    double size(Vec2 p) const override
    {
        const Vec2 along = b_ - a_;
        const double l2 = squaredLength(along);
        const double s = l2 > 0.0 ? std::clamp(dot(p - a_, along) / l2, 0.0, 1.0) : 0.0;
        return std::min(hMax_, h0_ + g_ * std::sqrt(squaredLength(p - a_ - s * along)));
    }
    double gradientBound() const override { return g_; }

private:
    Vec2 a_, b_;
    double h0_, g_, hMax_;
};

struct CircleCurve: Curve
{
    CircleCurve(Vec2 center, double radius)
        : center_(center)
        , radius_(radius)
    {}
    double first() const override { return 0.0; }
    double last() const override { return 2.0 * M_PI; }
    Vec2 point(double t) const override
    {
        return center_ + Vec2 {radius_ * std::cos(t), radius_ * std::sin(t)};
    }
    Vec2 derivative(double t) const override
    {
        return {-radius_ * std::sin(t), radius_ * std::cos(t)};
    }
    Vec2 secondDerivative(double t) const override
    {
        return {-radius_ * std::cos(t), -radius_ * std::sin(t)};
    }
    double radius() const { return radius_; }
    Vec2 center() const { return center_; }

private:
    Vec2 center_;
    double radius_;
};

/// A domain under construction: sampled boundary loops (even-odd) and constraint lines.
class Domain
{
public:
    struct Edge
    {
        std::uint32_t a, b;
        const Curve* geometry;
        double ta, tb;
        bool boundary;
    };

    std::vector<Vec2> points;
    std::vector<Edge> edges;
    std::vector<std::shared_ptr<const Curve>> curves;

    /// Straight loop, each side divided by the size field; nullptr: not divided.
    void addPolygon(const std::vector<Vec2>& corners, const SizeField* size);
    void addLine(Vec2 a, Vec2 b, const SizeField* size);
    void addCircle(Vec2 center, double radius, const SizeField& size);
    void addCircle(Vec2 center, double radius, int pieces);

    /// Unit square with five round holes and four inner lines.
    static Domain plate(const SizeField& size);
    /// Star polygon with holes and lines, reproducible from the seed. No holes touch.
    static Domain randomStar(unsigned seed, const SizeField& size);

    WorkingMesh build() const;

private:
    void addChain(std::uint32_t a, std::uint32_t b, const SizeField* size, bool boundary);
    std::uint32_t addPoint(Vec2 p);
};

struct Figures
{
    std::size_t triangles = 0;
    double area = 0.0;
    double minAngle = 180.0;
    double angleP01 = 0.0;
    double meanQuality = 0.0;
    double minQuality = 1.0;
    double p05 = 0.0, p95 = 0.0; ///< edge length / size
};

Figures measure(const WorkingMesh& mesh, const SizeField& size);

/// Everything that has to hold of a WorkingMesh beside verify(): records and bits agree, every
/// record of an original edge is a chain from its start to its end with monotone parameters, split
/// vertices lie on their curves, no vertex at infinity is kept. One sentence a problem.
std::vector<std::string> checkWorkingMesh(const WorkingMesh& mesh, const WorkingMesh& original);

namespace detail
{

/// Positions 0 .. 1 that divide a chain so that every part has the same integral of 1 / size.
inline std::vector<double> divide(const std::function<Vec2(double)>& at, double length,
                           const SizeField& size)
{
    constexpr int kSteps = 2000;
    std::vector<double> sum(kSteps + 1, 0.0);
    for (int i = 0; i < kSteps; ++i) {
        sum[i + 1] = sum[i] + length / kSteps / size.size(at((i + 0.5) / kSteps));
    }
    const int parts = std::max(1, static_cast<int>(std::lround(sum[kSteps])));
    std::vector<double> result {0.0};
    int step = 0;
    for (int k = 1; k < parts; ++k) {
        const double target = sum[kSteps] * k / parts;
        while (sum[step + 1] < target) {
            ++step;
        }
        result.push_back((step + (target - sum[step]) / (sum[step + 1] - sum[step])) / kSteps);
    }
    result.push_back(1.0);
    return result;
}

/// Marks what is inside by even-odd over the boundary edges.
inline void colorEvenOdd(WorkingMesh& mesh, const std::set<std::pair<std::uint32_t, std::uint32_t>>& walls)
{
    const Triangulation& t = mesh.triangulation;
    std::vector<int> parity(t.triangles.size(), -1);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isDead(i) && t.isGhost(i)) {
            parity[i] = 0;
            stack.push_back(i);
        }
    }
    while (!stack.empty()) {
        const std::uint32_t i = stack.back();
        stack.pop_back();
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge h = Topology::halfEdge(i, side);
            const std::uint32_t next = Topology::triangleOf(t.twin(h));
            if (parity[next] < 0) {
                const bool wall = walls.count(std::minmax(t.origin(h), t.destination(h))) != 0;
                parity[next] = parity[i] ^ (wall ? 1 : 0);
                stack.push_back(next);
            }
        }
    }
    mesh.regionOfTriangle.assign(t.triangles.size(), WorkingMesh::kOutside);
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (parity[i] == 1) {
            mesh.regionOfTriangle[i] = 0;
        }
    }
}

} // namespace detail

inline std::uint32_t Domain::addPoint(Vec2 p)
{
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (points[i] == p) {
            return i;
        }
    }
    points.push_back(p);
    return static_cast<std::uint32_t>(points.size() - 1);
}

inline void Domain::addChain(std::uint32_t a, std::uint32_t b, const SizeField* size, bool boundary)
{
    const Vec2 p = points[a];
    const Vec2 q = points[b];
    std::vector<double> at {0.0, 1.0};
    if (size != nullptr) {
        at = detail::divide([&](double s) { return p + s * (q - p); }, distance(p, q), *size);
    }
    std::uint32_t previous = a;
    for (std::size_t i = 1; i < at.size(); ++i) {
        std::uint32_t next = b;
        if (i + 1 < at.size()) {
            points.push_back(p + at[i] * (q - p));
            next = static_cast<std::uint32_t>(points.size() - 1);
        }
        edges.push_back({previous, next, nullptr, 0.0, 0.0, boundary});
        previous = next;
    }
}

inline void Domain::addPolygon(const std::vector<Vec2>& corners, const SizeField* size)
{
    std::vector<std::uint32_t> ids;
    for (const Vec2 p : corners) {
        ids.push_back(addPoint(p));
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
        addChain(ids[i], ids[(i + 1) % ids.size()], size, true);
    }
}

inline void Domain::addLine(Vec2 a, Vec2 b, const SizeField* size)
{
    const std::uint32_t p = addPoint(a);
    addChain(p, addPoint(b), size, false);
}

inline void Domain::addCircle(Vec2 center, double radius, const SizeField& size)
{
    const CircleCurve circle(center, radius);
    const auto at = detail::divide([&](double s) { return circle.point(2.0 * M_PI * s); },
                           2.0 * M_PI * radius, size);
    addCircle(center, radius, std::max(3, static_cast<int>(at.size()) - 1));
}

inline void Domain::addCircle(Vec2 center, double radius, int pieces)
{
    auto circle = std::make_shared<CircleCurve>(center, radius);
    curves.push_back(circle);
    const auto first = static_cast<std::uint32_t>(points.size());
    for (int i = 0; i < pieces; ++i) {
        const double t = 2.0 * M_PI * i / pieces;
        points.push_back(circle->point(t));
        edges.push_back({first + static_cast<std::uint32_t>(i),
                         first + static_cast<std::uint32_t>((i + 1) % pieces), circle.get(), t,
                         2.0 * M_PI * (i + 1) / pieces, true});
    }
}

inline Domain Domain::plate(const SizeField& size)
{
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    for (const Vec2 c : {Vec2 {0.22, 0.24}, Vec2 {0.78, 0.22}, Vec2 {0.24, 0.77},
                         Vec2 {0.76, 0.79}}) {
        d.addCircle(c, 0.08, size);
    }
    d.addCircle({0.52, 0.49}, 0.12, size);
    d.addLine({0.1, 0.45}, {0.3, 0.52}, &size);
    d.addLine({0.7, 0.55}, {0.92, 0.45}, &size);
    d.addLine({0.45, 0.08}, {0.55, 0.25}, &size);
    d.addLine({0.42, 0.72}, {0.58, 0.93}, &size);
    return d;
}

inline Domain Domain::randomStar(unsigned seed, const SizeField& size)
{
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (random() / 4294967296.0);
    };
    Domain d;
    const int corners = 6 + static_cast<int>(random() % 30);
    std::vector<Vec2> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * M_PI * i / corners;
        const double r = uniform(0.55, 1.0);
        outline.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    d.addPolygon(outline, &size);
    const int holes = static_cast<int>(random() % 3);
    for (int i = 0; i < holes; ++i) {
        const double angle = 2.0 * M_PI * i / 3.0 + uniform(-0.1, 0.1);
        const Vec2 center {0.25 * std::cos(angle), 0.25 * std::sin(angle)};
        d.addCircle(center, uniform(0.02, 0.12), size);
    }
    const int lines = static_cast<int>(random() % 3);
    for (int i = 0; i < lines; ++i) {
        const double angle = 2.0 * M_PI * (2 + i) / 3.0 + uniform(0.5, 0.9);
        const Vec2 u {std::cos(angle), std::sin(angle)};
        d.addLine(uniform(0.1, 0.2) * u, uniform(0.25, 0.4) * u, &size);
    }
    return d;
}

inline WorkingMesh Domain::build() const
{
    Execution execution;
    DelaunayResult delaunay = triangulate(points, execution);
    std::vector<ConstraintEnds> ends;
    for (const Edge& e : edges) {
        ends.push_back({delaunay.vertexOfPoint[e.a], delaunay.vertexOfPoint[e.b]});
    }
    RecoveryResult recovered = recoverBoundaries(std::move(delaunay.triangulation), ends,
                                                 RecoveryStrategy::Cavity, execution);
    WorkingMesh mesh;
    std::set<std::pair<std::uint32_t, std::uint32_t>> walls;
    for (std::uint32_t i = 0; i < recovered.constraints.subsegments.size(); ++i) {
        const Subsegment& s = recovered.constraints.subsegments[i];
        const ConstraintUse use = recovered.constraints.usesOf(s)[0];
        const Edge& e = edges[use.constraint.index()];
        ConstrainedEdge record {s.a, s.b, i, e.geometry, e.ta, e.tb};
        if (!use.forward) {
            std::swap(record.ta, record.tb);
        }
        mesh.edges.push_back(record);
        if (e.boundary) {
            walls.insert(std::minmax(s.a, s.b));
        }
    }
    mesh.triangulation = std::move(recovered.triangulation);
    mesh.origin.assign(mesh.triangulation.points.size(), VertexOrigin::Input);
    detail::colorEvenOdd(mesh, walls);
    return mesh;
}

inline Figures measure(const WorkingMesh& mesh, const SizeField& size)
{
    Figures f;
    const Triangulation& t = mesh.triangulation;
    std::vector<double> angles;
    std::vector<double> lengths;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (mesh.regionOfTriangle[i] == WorkingMesh::kOutside || !t.isFinite(i)) {
            continue;
        }
        const auto& v = t.triangles[i].v;
        const Vec2 p[3] = {t.points[v[0]], t.points[v[1]], t.points[v[2]]};
        const double area = 0.5 * cross(p[1] - p[0], p[2] - p[0]);
        double squares = 0.0;
        double smallest = 180.0;
        for (int k = 0; k < 3; ++k) {
            const Vec2 u = p[(k + 1) % 3] - p[k];
            const Vec2 w = p[(k + 2) % 3] - p[k];
            squares += squaredLength(u);
            smallest = std::min(smallest, std::atan2(cross(u, w), dot(u, w)) * 180.0 / M_PI);
            if (v[k] < v[(k + 1) % 3]) {
                lengths.push_back(length(u) / size.size(midpoint(p[k], p[(k + 1) % 3])));
            }
        }
        angles.push_back(smallest);
        f.area += area;
        const double q = 4.0 * std::numbers::sqrt3 * area / squares;
        f.meanQuality += q;
        f.minQuality = std::min(f.minQuality, q);
    }
    f.triangles = angles.size();
    if (angles.empty()) {
        return f;
    }
    f.meanQuality /= static_cast<double>(angles.size());
    std::sort(angles.begin(), angles.end());
    std::sort(lengths.begin(), lengths.end());
    f.minAngle = angles.front();
    f.angleP01 = angles[angles.size() / 100];
    f.p05 = lengths[lengths.size() / 20];
    f.p95 = lengths[lengths.size() * 19 / 20];
    return f;
}

inline std::vector<std::string> checkWorkingMesh(const WorkingMesh& mesh, const WorkingMesh& original)
{
    std::vector<std::string> problems;
    const Triangulation& t = mesh.triangulation;
    if (mesh.regionOfTriangle.size() != t.triangles.size()
        || mesh.origin.size() != t.points.size()) {
        problems.push_back("an array has the wrong length");
        return problems;
    }
    std::size_t bits = 0;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isFinite(i) && mesh.regionOfTriangle[i] != WorkingMesh::kOutside) {
            problems.push_back("a ghost or dead triangle is kept");
        }
        for (std::uint32_t side = 0; side < 3 && !t.isDead(i); ++side) {
            const HalfEdge h = Topology::halfEdge(i, side);
            const std::uint32_t other = Topology::triangleOf(t.twin(h));
            bits += t.isConstrained(h) ? 1 : 0;
            if (!t.isConstrained(h) && mesh.regionOfTriangle[i] != mesh.regionOfTriangle[other]) {
                problems.push_back("two regions meet at an edge that is not constrained");
            }
        }
    }
    if (bits != 2 * mesh.edges.size()) {
        problems.push_back("records and constrained edges differ in number");
    }
    std::map<std::uint32_t, std::map<std::uint32_t, const ConstrainedEdge*>> piecesOf;
    for (const ConstrainedEdge& e : mesh.edges) {
        const HalfEdge h = t.findEdge(e.a, e.b);
        if (h == Topology::kDead || !t.isConstrained(h)) {
            problems.push_back("a record is no constrained edge");
        }
        if (e.geometry != nullptr) {
            for (const auto& [v, parameter] : {std::pair {e.a, e.ta}, std::pair {e.b, e.tb}}) {
                if (distance(e.geometry->point(parameter), t.points[v]) > 1e-12) {
                    problems.push_back("a vertex is not on its curve");
                }
            }
        }
        piecesOf[e.useSet][e.a] = &e;
    }
    for (const ConstrainedEdge& e : original.edges) {
        const auto& pieces = piecesOf[e.useSet];
        std::uint32_t v = e.a;
        double parameter = e.ta;
        std::size_t count = 0;
        while (v != e.b && count <= pieces.size()) {
            const auto piece = pieces.find(v);
            if (piece == pieces.end() || piece->second->ta != parameter
                || (e.geometry != nullptr
                    && (piece->second->tb - piece->second->ta) * (e.tb - e.ta) <= 0.0)) {
                problems.push_back("a constraint is no chain any more");
                break;
            }
            v = piece->second->b;
            parameter = piece->second->tb;
            ++count;
        }
        if (count != pieces.size()) {
            problems.push_back("a constraint has pieces beside its chain");
        }
        for (const auto& [from, piece] : pieces) {
            const Vec2 a = original.triangulation.points[e.a];
            const Vec2 b = original.triangulation.points[e.b];
            if (e.geometry == nullptr
                && std::fabs(cross(b - a, t.points[from] - a)) > 1e-14 * distance(a, b)) {
                problems.push_back("a vertex is off its straight constraint");
            }
        }
    }
    for (std::uint32_t v = 1; v < original.triangulation.points.size(); ++v) {
        if (t.points[v] != original.triangulation.points[v]) {
            problems.push_back("an original vertex has moved");
        }
    }
    return problems;
}

} // namespace tessera::test
