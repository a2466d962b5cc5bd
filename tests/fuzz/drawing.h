// SPDX-License-Identifier: MIT
#pragma once

// A fuzzer's bytes as a small drawing and the options to mesh it with.
//
// Byte 0: bits 0-2 the kind of coordinates, bit 3 whether everything lies in a frame, bits 4-6 the
// fill rule, bit 7 whether crossings are found by Steiner points. Bytes 1-5: see options(). Then
// shapes: a byte for the kind, one for role, operand and points that are used again, its points.

#include "coordinates.h"

#include "base/box2.h"
#include "curve/arc.h"
#include "curve/polyline.h"
#include "pipeline.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace tessera::fuzz
{

/// What one input asks for.
struct Drawing
{
    CurveNetwork network;
    MeshOptions options;
    bool straight = true;    ///< no curve has a geometry
    bool roomy = true; ///< whole numbers, no needles, nothing welded: roundings are far smaller
    bool twoThreads = false; ///< the second run: on two threads
    int cancelAfter = 0;     ///< the second run: cancelled when progress was told so often; 0: never
};

class DrawingMaker
{
public:
    DrawingMaker(const std::uint8_t* data, std::size_t size)
        : bytes_(data, size)
    {}

    Drawing make()
    {
        CurveNetwork& network = drawing_.network;
        network.operands.push_back({"first"});
        network.operands.push_back({"second"});
        const auto head = bytes_.take<std::uint8_t>();
        kind_ = head & 7;
        drawing_.roomy = kind_ == Integers;
        const auto wanted = bytes_.take<std::array<std::uint8_t, 5>>();
        constexpr std::array kRules {FillRule::EvenOdd,  FillRule::EvenOdd,  FillRule::EvenOdd,
                                     FillRule::NonZero,  FillRule::Positive, FillRule::Negative,
                                     FillRule::All,      FillRule::Hull};
        drawing_.options.fill = kRules[(head >> 4) & 7];
        drawing_.options.recovery =
            (head & 128) != 0 ? RecoveryStrategy::Steiner : RecoveryStrategy::Cavity;
        constexpr std::size_t kMostShapes = 10;
        for (std::size_t i = 0; i < kMostShapes && !bytes_.empty(); ++i) {
            addShape();
        }
        Box2 box;
        for (const Vec2 p : network.points) {
            box.add(p);
        }
        if ((head & 8) != 0 && !network.points.empty()) {
            addPolygon({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}});
        }
        options(wanted, network.points.empty() ? 0.0 : box.diagonal());
        return std::move(drawing_);
    }

private:
    /// Byte 1: bits 0-2 the size, bits 3 and 4 a number of triangles instead, bit 5 a smallest size, bit 6
    /// boundaries that stay, bit 7 no optimizing. Byte 2: bits 0-5 the angle, bits 6-7 the second
    /// run. Byte 3: the growth, the share for narrow places. Byte 4: the area, elements across gaps.
    /// Byte 5: order, welding, a place with a size of its own.
    void options(const std::array<std::uint8_t, 5>& wanted, double diagonal)
    {
        MeshOptions& options = drawing_.options;
        const int parts = 1 + (wanted[0] & 7);
        if ((wanted[0] & 24) == 24) { // takes many runs
            options.count = static_cast<std::size_t>(parts * parts);
        }
        else {
            options.size = diagonal / parts;
        }
        options.minSize = (wanted[0] & 32) != 0 ? diagonal / 30.0 : 0.0;
        options.freezeBoundary = (wanted[0] & 64) != 0;
        options.optimize = (wanted[0] & 128) == 0;
        options.minAngle = 33.0 * (wanted[1] & 63) / 63.0;
        drawing_.twoThreads = (wanted[1] >> 6) == 1;
        drawing_.cancelAfter = (wanted[1] >> 6) == 2 ? 1 + wanted[4] % 32 : 0;
        options.growth = (1 + (wanted[2] & 15)) / 16.0;
        constexpr std::array kShares {2.0, 0.0, 0.1, 0.5, 1.0, 2.0, 8.0, 100.0};
        options.narrowShare = kShares[(wanted[2] >> 4) & 7];
        if ((wanted[3] & 15) != 0) {
            options.maxArea = 0.5 * diagonal * diagonal / (1 << ((wanted[3] & 15) - 1) / 3);
        }
        // Many elements across the narrowest gaps take far longer than there is.
        options.sizes.gap = options.minSize > 0.0 ? (wanted[3] >> 4) & 3 : 0;
        options.sizes.piecesPerTurn = (wanted[3] & 64) != 0 ? 5.0 : 20.0;
        options.order = (wanted[4] & 32) != 0 ? 2 : 1;
        options.weld = (wanted[4] & 64) != 0 ? 1e-6 * diagonal : -1.0;
        drawing_.roomy = drawing_.roomy && options.weld < 0.0;
        if ((wanted[4] & 128) != 0 && diagonal > 0.0) {
            options.sizes.points.push_back({drawing_.network.points[0], {diagonal / 32.0}});
        }
        // 250 bytes each: more than 2,000 triangles are refused.
        options.memoryLimit = 5e5;
    }

    void addShape()
    {
        const auto shape = bytes_.take<std::uint8_t>();
        const auto how = bytes_.take<std::uint8_t>();
        constexpr std::array kRoles {Role::Boundary,   Role::Boundary, Role::Boundary, Role::Boundary,
                                     Role::Constraint, Role::Outline,  Role::Chain,    Role::Ignored};
        role_ = kRoles[how & 7];
        operand_ = OperandId((how >> 3) & 1U);
        again_ = how >> 4; // one bit for each of the first points
        const int more = shape >> 3;
        switch (shape & 7) {
        case 0:
        case 1:
            addPolygon(points(3 + more % 6));
            break;
        case 2:
            role_ = role_ == Role::Boundary ? Role::Constraint : role_;
            addLines(points(2 + more % 4));
            break;
        case 3:
            addNeedle(more);
            break;
        case 4:
            addCircle();
            break;
        case 5:
            addArc(more);
            break;
        case 6:
            addCurve(std::make_shared<PolylineCurve>(points(2 + more % 4)));
            break;
        default:
            addPoint(more);
        }
    }

    Vec2 nextPoint()
    {
        const std::vector<Vec2>& before = drawing_.network.points;
        const bool again = (again_ & 1) != 0;
        again_ >>= 1;
        return again && !before.empty() ? before[bytes_.take<std::uint8_t>() % before.size()]
                                        : point(bytes_, kind_);
    }

    std::vector<Vec2> points(int count)
    {
        std::vector<Vec2> result;
        for (int i = 0; i < count; ++i) {
            result.push_back(nextPoint());
        }
        return result;
    }

    void addPolygon(const std::vector<Vec2>& corners)
    {
        addPolyline(drawing_.network, corners, true, operand_, role_);
    }

    void addLines(const std::vector<Vec2>& corners)
    {
        addPolyline(drawing_.network, corners, false, operand_, role_);
    }

    /// Two lines from one point, which end so near to each other, and what closes them.
    void addNeedle(int more)
    {
        const Vec2 p = nextPoint();
        const Vec2 q = nextPoint();
        const double width = std::pow(10.0, -1.0 - more % 16);
        drawing_.roomy = drawing_.roomy && width > 1e-6;
        const Vec2 across {-width * (q.y - p.y), width * (q.x - p.x)};
        addPolygon({p, q, q + across});
    }

    void addCircle()
    {
        const Vec2 center = nextPoint();
        const double radius = distance(center, nextPoint());
        if (radius > 0.0) {
            addCurve(makeCircleArc(center, radius, 0.0, 2.0 * std::numbers::pi));
        }
    }

    void addArc(int more)
    {
        const Vec2 center = nextPoint();
        const Vec2 u = nextPoint() - center;
        const Vec2 v = (more & 1) != 0 ? nextPoint() - center : Vec2 {-u.y, u.x};
        const double first = (bytes_.take<std::uint8_t>() % 24) * std::numbers::pi / 12.0;
        addCurve(std::make_shared<EllipseArc>(center, u, v, first,
                                              first + (1 + more / 2) * std::numbers::pi / 12.0));
    }

    void addCurve(std::shared_ptr<const Curve> geometry)
    {
        CurveNetwork& network = drawing_.network;
        drawing_.straight = false;
        const PointId start = network.addPoint(geometry->point(geometry->first()));
        const PointId end = network.addPoint(geometry->point(geometry->last()));
        network.curves.push_back({std::move(geometry), start, end, operand_, role_});
    }

    void addPoint(int more)
    {
        CurveNetwork& network = drawing_.network;
        const Vec2 p = nextPoint();
        if (more % 3 == 0) {
            network.holes.push_back({p, operand_});
        }
        else if (more % 3 == 1) {
            network.regions.push_back({p, operand_, 1.0, 0.0});
        }
        else {
            network.embedded.push_back({network.addPoint(p), operand_, "point"});
        }
    }

    Bytes bytes_;
    Drawing drawing_;
    int kind_ = 0;
    Role role_ = Role::Boundary; ///< of the shape
    OperandId operand_ {0U};
    int again_ = 0;
};

} // namespace tessera::fuzz
