// SPDX-License-Identifier: MIT
#pragma once

// Random domains that are the same on every machine: star polygons with corners down to 20 degrees,
// round holes, inner lines that may cross; and what is expected of their meshes.

#include "curve/arc.h"
#include "pipeline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tessera::testing
{

struct RandomDomain
{
    CurveNetwork network;
    double smallestAngle = 180.0; ///< between curves that meet or cross, degrees
};

class RandomDomainMaker
{
public:
    explicit RandomDomainMaker(unsigned seed)
        : random_(seed)
    {}

    RandomDomain make()
    {
        domain_.network.operands.push_back({"domain"});
        addOutline();
        const int holes = static_cast<int>(random_() % 4);
        for (int i = 0; i < holes; ++i) {
            addHole();
        }
        const int lines = static_cast<int>(random_() % 4);
        for (int i = 0; i < lines; ++i) {
            addLine();
        }
        return std::move(domain_);
    }

private:
    struct Disk
    {
        Vec2 center;
        double radius;
    };
    struct Line
    {
        Vec2 a, b;
    };

    double uniform(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }

    static double angleBetween(Vec2 u, Vec2 w)
    {
        return std::fabs(std::atan2(cross(u, w), dot(u, w))) * 180.0 / std::numbers::pi;
    }

    /// A star polygon, made rounder until no corner is below 20 degrees.
    void addOutline()
    {
        const int count = 12 + static_cast<int>(random_() % 60);
        std::vector<double> radii;
        for (int i = 0; i < count; ++i) {
            radii.push_back(uniform(0.0, 1.0));
        }
        std::vector<Vec2> corners(radii.size());
        double smallest = 0.0;
        for (double depth = uniform(0.1, 0.7); smallest < 20.0; depth *= 0.9) {
            inner_ = 1.0 - depth;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / count;
                const double r = 1.0 - depth * radii[i];
                corners[i] = {r * std::cos(angle), r * std::sin(angle)};
            }
            smallest = 180.0;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Vec2 p = corners[i];
                smallest = std::min(smallest,
                                    angleBetween(corners[(i + 1) % corners.size()] - p,
                                                 corners[(i + corners.size() - 1) % corners.size()] - p));
            }
        }
        domain_.smallestAngle = smallest;
        CurveNetwork& network = domain_.network;
        std::vector<PointId> ids;
        for (const Vec2 p : corners) {
            ids.push_back(network.addPoint(p));
        }
        for (std::size_t i = 0; i < ids.size(); ++i) {
            addStraight(ids[i], ids[(i + 1) % ids.size()], Role::Boundary);
        }
        // Sides between corners come nearer to the center than these.
        inner_ *= 0.9 * std::cos(std::numbers::pi / count);
    }

    void addStraight(PointId a, PointId b, Role role)
    {
        NetworkCurve curve;
        curve.start = a;
        curve.end = b;
        curve.operand = OperandId(0U);
        curve.role = role;
        domain_.network.curves.push_back(curve);
    }

    void addHole()
    {
        const double radius = uniform(0.05, 0.25) * inner_;
        const double angle = uniform(0.0, 2.0 * std::numbers::pi);
        const double away = uniform(0.0, inner_ - radius);
        const Vec2 center {away * std::cos(angle), away * std::sin(angle)};
        for (const Disk& other : holes_) {
            if (distance(center, other.center) < 1.2 * (radius + other.radius)) {
                return;
            }
        }
        holes_.push_back({center, radius});
        NetworkCurve circle;
        circle.geometry = makeCircleArc(center, radius, 0.0, 2.0 * std::numbers::pi);
        circle.start = domain_.network.addPoint(circle.geometry->point(circle.geometry->first()));
        circle.end = circle.start;
        circle.operand = OperandId(0U);
        domain_.network.curves.push_back(circle);
    }

    static double distanceToLine(Vec2 p, const Line& line)
    {
        const Vec2 along = line.b - line.a;
        const double s = std::clamp(dot(p - line.a, along) / squaredLength(along), 0.0, 1.0);
        return distance(p, line.a + s * along);
    }

    static bool cross(const Line& l, const Line& m)
    {
        const auto side = [](const Line& line, Vec2 p) { return cross(line.b - line.a, p - line.a); };
        return side(l, m.a) * side(l, m.b) < 0.0 && side(m, l.a) * side(m, l.b) < 0.0;
    }
    static double cross(Vec2 a, Vec2 b) { return tessera::cross(a, b); }

    /// A line that keeps off the holes; it may cross other lines, at 20 degrees or more.
    void addLine()
    {
        constexpr double kApart = 0.03;
        const double angle = uniform(0.0, 2.0 * std::numbers::pi);
        const double turn = uniform(0.3, 3.0);
        const Vec2 u {std::cos(angle), std::sin(angle)};
        const Vec2 w {std::cos(angle + turn), std::sin(angle + turn)};
        const Line line {uniform(0.1, 0.95) * inner_ * u, uniform(0.1, 0.95) * inner_ * w};
        if (distance(line.a, line.b) < 0.1) {
            return;
        }
        for (const Disk& hole : holes_) {
            if (distanceToLine(hole.center, line) < hole.radius + kApart) {
                return;
            }
        }
        double smallest = domain_.smallestAngle;
        for (const Line& other : lines_) {
            const double ends = std::min({distanceToLine(line.a, other), distanceToLine(line.b, other),
                                          distanceToLine(other.a, line), distanceToLine(other.b, line)});
            if (ends < kApart) {
                return;
            }
            if (cross(line, other)) {
                const double turned = angleBetween(line.b - line.a, other.b - other.a);
                const double between = std::min(turned, 180.0 - turned);
                if (between < 20.0) {
                    return;
                }
                smallest = std::min(smallest, between);
            }
        }
        domain_.smallestAngle = smallest;
        lines_.push_back(line);
        const PointId a = domain_.network.addPoint(line.a);
        addStraight(a, domain_.network.addPoint(line.b), Role::Constraint);
    }

    std::mt19937 random_;
    RandomDomain domain_;
    double inner_ = 0.0; ///< radius of a disk inside the outline
    std::vector<Disk> holes_;
    std::vector<Line> lines_;
};

/// What is counted over many random domains.
struct RandomDomainTally
{
    std::size_t domains = 0;
    std::size_t triangles = 0;
    std::size_t broken = 0;  ///< not counter-clockwise, or not the area that its outline encloses
    std::size_t hidden = 0;  ///< triangles below min(30, smallest input angle), not in unreached
    std::size_t below = 0;   ///< domains with an angle below that bound, in unreached or not
    std::size_t blunt = 0;   ///< domains without an angle below 60 degrees
    std::size_t bluntGood = 0; ///< those with no angle below 32 degrees in the mesh
    double worst = 180.0;

    void add(unsigned seed, double size)
    {
        const RandomDomain domain = RandomDomainMaker(seed).make();
        Execution execution;
        MeshOptions options;
        options.size = size;
        const MeshResult made = meshNetwork(domain.network, options, execution);
        const MeshReport& report = made.report;
        ++domains;
        triangles += made.mesh.triangles.size();
        broken += isSound(made.mesh) ? 0 : 1;
        const double bound = std::min(30.0, domain.smallestAngle) - 1e-6;
        hidden += countHidden(made, bound);
        below += report.quality.minAngle < bound ? 1 : 0;
        worst = std::min(worst, report.quality.minAngle);
        if (domain.smallestAngle >= 60.0) {
            ++blunt;
            bluntGood += report.quality.minAngle >= 32.0 ? 1 : 0;
        }
    }

private:
    static bool isSound(const Mesh& mesh)
    {
        double area = 0.0;
        for (const auto& t : mesh.triangles) {
            const Vec2 a = mesh.nodes[t[0]];
            const double twice = cross(mesh.nodes[t[1]] - a, mesh.nodes[t[2]] - a);
            if (!(twice > 0.0)) {
                return false;
            }
            area += 0.5 * twice;
        }
        double enclosed = 0.0;
        for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
            if (mesh.edgeIsOutline[e] != 0) {
                enclosed += 0.5 * cross(mesh.nodes[mesh.edges[e][0]], mesh.nodes[mesh.edges[e][1]]);
            }
        }
        return std::fabs(area - enclosed) < 1e-9;
    }

    static std::size_t countHidden(const MeshResult& made, double bound)
    {
        std::size_t hidden = 0;
        for (const auto& t : made.mesh.triangles) {
            const Vec2 a = made.mesh.nodes[t[0]];
            const Vec2 b = made.mesh.nodes[t[1]];
            const Vec2 c = made.mesh.nodes[t[2]];
            if (triangleAngles(a, b, c).smallest >= bound) {
                continue;
            }
            const Vec2 center = (1.0 / 3.0) * (a + b + c);
            hidden += std::none_of(made.report.unreached.begin(), made.report.unreached.end(),
                                   [&](const Unreached& item) {
                                       return distance(item.place, center) < 1e-9;
                                   })
                ? 1
                : 0;
        }
        return hidden;
    }
};

} // namespace tessera::testing
