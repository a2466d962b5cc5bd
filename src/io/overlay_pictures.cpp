// SPDX-License-Identifier: MIT
#include "io/overlay_pictures.h"

#include "io/counted.h"
#include "io/drawing.h"

#include <fmt/format.h>

#include <array>

namespace tessera
{

namespace
{

constexpr Color kWire {0.56, 0.64, 0.72};
constexpr Color kBoundary {0.08, 0.13, 0.24};
constexpr Color kLoopT {0.13, 0.35, 0.66};
constexpr Color kLoopS {0.80, 0.33, 0.10};
constexpr std::array<Color, 4> kThetaColors {
    {{0.62, 0.53, 0.76}, {0.60, 0.76, 0.93}, {0.98, 0.78, 0.55}, {0.96, 0.97, 0.98}}};
constexpr double kWireFrom = 14.0; ///< pixels of an edge from which on it has its full width

/// The finite triangles with their class; classOf gives kNone for those left out.
template<class ClassOf>
DrawnTriangles drawnTriangles(const Triangulation& t, ClassOf&& classOf)
{
    DrawnTriangles drawn;
    drawn.points = t.points;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        const std::uint32_t c = t.isFinite(i) ? classOf(i) : DrawnTriangles::kNone;
        if (c != DrawnTriangles::kNone) {
            const auto& v = t.triangles[i].v;
            drawn.corners.push_back({v[0], v[1], v[2]});
            drawn.classOf.push_back(c);
        }
    }
    return drawn;
}

std::vector<DrawnEdge> subsegments(const RecoveryResult& recovered)
{
    std::vector<DrawnEdge> edges;
    for (const Subsegment& s : recovered.constraints.subsegments) {
        edges.push_back({s.a, s.b});
    }
    return edges;
}

void fillAndStroke(Canvas& canvas, const OverlayResult& result, const DrawnTriangles& drawn,
                   std::span<const Color> colors)
{
    const auto& points = result.recovered.triangulation.points;
    const std::vector<DrawnEdge> sides = sidesOf(drawn);
    fillClasses(canvas, points, sides, colors);
    strokeEdges(canvas, points, sides, {kWire, 1.3, kWireFrom, 0.12});
    strokeEdges(canvas, points, subsegments(result.recovered), {kBoundary, 2.8, 10.0, 0.9});
}

} // namespace

void OverlayPictures::colored(const OverlayResult& result)
{
    drawLoops(result);
    if (result.parts.theta.empty()) {
        drawParts(result);
    }
    else {
        drawTheta(result);
    }
}

void OverlayPictures::drawLoops(const OverlayResult& result)
{
    const std::size_t operands = result.input.operands.size();
    const std::string caption = operands == 2
        ? "The loops of the operands t (blue) and s (orange)"
        : "The loops of " + counted(operands, "operand");
    save("0-loops", domain(), caption, [&result, operands](Canvas& canvas) {
        for (const PslgSegment& segment : result.pslg.segments) {
            const OperandId operand = result.network().curves[segment.curve.index()].operand;
            const Color color = operands != 2 ? kBoundary
                : operand.value == 0          ? kLoopT
                                              : kLoopS;
            canvas.line(result.pslg.points[segment.a.index()],
                        result.pslg.points[segment.b.index()], 4.0, color);
        }
    });
}

void OverlayPictures::drawTheta(const OverlayResult& result)
{
    const auto& theta = result.parts.theta;
    const auto all = drawnTriangles(result.recovered.triangulation, [&theta](std::uint32_t t) {
        return static_cast<std::uint32_t>(theta[t]);
    });
    save("5-colors", domain(),
         "Colors: both (violet), t only (blue), s only (orange), outside (white)",
         [&](Canvas& canvas) { fillAndStroke(canvas, result, all, kThetaColors); });
    const ThetaAreas areas = result.report.theta.value_or(ThetaAreas {});
    const struct
    {
        Theta theta;
        const char* name;
        const char* what;
        double area;
    } sets[] = {{Theta::O, "5-theta-o", "in both operands", areas.o},
                {Theta::T, "5-theta-t", "in t and not in s", areas.t},
                {Theta::S, "5-theta-s", "in s and not in t", areas.s}};
    for (const auto& set : sets) {
        const auto drawn =
            drawnTriangles(result.recovered.triangulation, [&theta, &set](std::uint32_t t) {
                return theta[t] == set.theta ? 0U : DrawnTriangles::kNone;
            });
        save(set.name, domain(), fmt::format("The triangles {}: area {:.6g}", set.what, set.area),
             [&](Canvas& canvas) {
                 const Color color = kThetaColors[static_cast<std::size_t>(set.theta)];
                 fillAndStroke(canvas, result, drawn, std::array {color});
             });
    }
}

void OverlayPictures::drawParts(const OverlayResult& result)
{
    const auto& partOf = result.parts.partOfTriangle;
    const auto drawn = drawnTriangles(result.recovered.triangulation, [&partOf](std::uint32_t t) {
        return partOf[t]; // kNoPart is kNone
    });
    static_assert(BooleanParts::kNoPart == DrawnTriangles::kNone);
    const std::size_t count = result.parts.parts.size();
    save("5-colors", domain(), "The result: " + counted(count, "part"),
         [&](Canvas& canvas) {
             fillAndStroke(canvas, result, drawn, chooseColors(sidesOf(drawn), count));
         });
}

} // namespace tessera
