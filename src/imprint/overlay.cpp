// SPDX-License-Identifier: MIT
//
// The pipeline stopped after the colors. Straight input needs neither arranging nor sampling: its
// curves are the constraints, and boundary recovery finds their crossings. Where only polygons are
// wanted, coherent chains are contracted first and put back into the polygons (contraction.h).
#include "imprint/overlay.h"

#include "arrange/arrange.h"
#include "base/box2.h"
#include "curve/chord_area.h"
#include "curve/curve_tools.h"
#include "curve/network_check.h"
#include "imprint/contraction.h"
#include "imprint/empty_overlay.h"
#include "recover/constraint_map.h"
#include "recover/snap_message.h"
#include "sample/sample.h"
#include "sizing/uniform_size.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace tessera
{

namespace
{

constexpr double kDefaultChordError = 1e-5; ///< of the bounding box's diagonal
constexpr double kFacePiecesPerTurn = 12.0;

bool isStraight(const CurveNetwork& network)
{
    return std::all_of(network.curves.begin(), network.curves.end(), [](const NetworkCurve& curve) {
        return curve.geometry == nullptr && curve.role != Role::Chain;
    });
}

class Overlay
{
public:
    Overlay(CurveNetwork network, const OverlayOptions& options, Execution& execution,
            StageObserver* stages)
        : options_(options)
        , execution_(execution)
        , stages_(stages)
        , stopwatch_(stages)
    {
        result_.input = std::move(network);
    }

    OverlayResult run()
    {
        arrangeStage();
        triangulateStage();
        recoverStage();
        colorStage();
        outlineStage();
        noteOrigins();
        result_.report.seconds.total = stopwatch_.total();
        return std::move(result_);
    }

private:
    /// An area that the triangles on the left of a side miss and those on the right have too much.
    struct SideArea
    {
        std::uint32_t left;
        std::uint32_t right;
        double area;
    };

    void arrangeStage()
    {
        execution_.beginStage("arrange", 0.0, 0.1);
        const CurveNetwork& network = result_.input;
        OverlayReport& report = result_.report;
        report.inputPoints = network.points.size();
        report.inputCurves = network.curves.size();
        report.inputSegments = static_cast<std::size_t>(
            std::count_if(network.curves.begin(), network.curves.end(),
                          [](const NetworkCurve& curve) { return curve.geometry == nullptr; }));
        report.inputOperands = network.operands.size();
        report.weld = options_.weld;
        if (options_.weld == 0.0 && isStraight(network)) {
            requireValid(network);
            takeSegments();
            firstCrossing_ = network.points.size();
            stopwatch_.lap(report.seconds.arrange);
            return;
        }
        ArrangeOptions arrangeOptions;
        arrangeOptions.weld = options_.weld;
        arrangeOptions.recovery = options_.recovery;
        ArrangeReport arranged;
        result_.arranged = arrange(network, arrangeOptions, arranged, execution_);
        firstCrossing_ = arranged.firstCrossing;
        result_.parent = std::move(arranged.parent);
        report.recovery = arranged.crossed;
        report.welded = arranged.welded;
        report.messages = std::move(arranged.messages);
        stopwatch_.lap(report.seconds.arrange);
        sampleStage();
    }

    void takeSegments()
    {
        const CurveNetwork& network = result_.input;
        Pslg& pslg = result_.pslg;
        pslg.points = network.points;
        pslg.segments.reserve(network.curves.size());
        for (std::size_t c = 0; c < network.curves.size(); ++c) {
            const NetworkCurve& curve = network.curves[c];
            if (curve.role != Role::Ignored) {
                pslg.segments.push_back({curve.start, curve.end, CurveId(c), 0.0, 1.0});
            }
        }
    }

    void sampleStage()
    {
        execution_.beginStage("sample", 0.1, 0.2);
        const Box2 box = networkBounds(*result_.arranged);
        const double diagonal = box.diagonal() > 0.0 ? box.diagonal() : 1.0;
        SampleOptions sampleOptions;
        sampleOptions.straightSegments = false;
        sampleOptions.chordError = options_.chordError;
        if (options_.form == OverlayForm::Faces) {
            sampleOptions.piecesPerTurn = kFacePiecesPerTurn;
            sampleOptions.growth = std::numeric_limits<double>::infinity();
        }
        else if (options_.chordError == 0.0) {
            sampleOptions.chordError = kDefaultChordError * diagonal;
        }
        result_.pslg = sample(*result_.arranged, UniformSize(diagonal), sampleOptions, execution_);
        stopwatch_.lap(result_.report.seconds.sample);
    }

    void triangulateStage()
    {
        execution_.beginStage("triangulate", 0.2, 0.4);
        Box2 box;
        for (const Vec2 p : result_.pslg.points) {
            box.add(p);
        }
        result_.rectangle = makeInitialRectangle(box);
        if (options_.form != OverlayForm::Triangles && stages_ == nullptr) {
            contraction_ = contract(result_.pslg, result_.network(), execution_);
        }
        delaunay_ = triangulate(divided().points, execution_);
        stopwatch_.lap(result_.report.seconds.triangulate);
        if (stages_ != nullptr) {
            stages_->initialRectangle(result_.rectangle);
            stages_->pointsInserted(delaunay_.triangulation, result_.rectangle);
        }
    }

    /// What is triangulated.
    const Pslg& divided() const { return contraction_ ? contraction_->pslg : result_.pslg; }

    void recoverStage()
    {
        execution_.beginStage("recover", 0.4, 0.7);
        recoverSegments();
        if (contraction_ && !isExpandable(*contraction_, result_.recovered)) {
            contraction_.reset();
            delaunay_ = triangulate(result_.pslg.points, execution_);
            recoverSegments();
        }
        addRecovery(result_.recovered.report);
        if (std::string text = describeSnapping(result_.report.recovery); !text.empty()) {
            result_.report.messages.push_back(std::move(text));
        }
        vertexOfPoint_.resize(delaunay_.vertexOfPoint.size());
        std::transform(delaunay_.vertexOfPoint.begin(), delaunay_.vertexOfPoint.end(),
                       vertexOfPoint_.begin(),
                       [this](std::uint32_t v) { return result_.recovered.vertexMap[v]; });
        stopwatch_.lap(result_.report.seconds.recover);
    }

    void recoverSegments()
    {
        std::vector<ConstraintEnds> ends;
        ends.reserve(divided().segments.size());
        for (const PslgSegment& segment : divided().segments) {
            ends.push_back({delaunay_.vertexOfPoint[segment.a.index()],
                            delaunay_.vertexOfPoint[segment.b.index()]});
        }
        result_.recovered = recoverBoundaries(std::move(delaunay_.triangulation), ends,
                                              options_.recovery, execution_, stages_);
    }

    void noteOrigins()
    {
        std::vector<VertexOrigin>& origin = result_.origin;
        origin.assign(result_.recovered.triangulation.points.size(), VertexOrigin::CurveSample);
        for (std::size_t p = result_.network().points.size(); p-- > 0;) {
            origin[vertexOfPoint_[p]] =
                p < firstCrossing_ ? VertexOrigin::Input : VertexOrigin::Crossing;
        }
        std::fill(origin.begin() + result_.recovered.firstCrossing, origin.end(),
                  VertexOrigin::Crossing);
    }

    /// Crossings of curves were counted by arrange, those of straight pieces now.
    void addRecovery(const RecoveryReport& found)
    {
        RecoveryReport& sum = result_.report.recovery;
        sum.crossings += found.crossings;
        sum.touches += found.touches;
        sum.overlaps = found.overlaps;
        sum.steinerInserted += found.steinerInserted;
        sum.steinerRemoved += found.steinerRemoved;
        sum.maxDisplacement = std::max(sum.maxDisplacement, found.maxDisplacement);
        sum.snapPixel = std::max(sum.snapPixel, found.snapPixel);
    }

    void colorStage()
    {
        execution_.beginStage("color", 0.7, 0.9);
        const BooleanOptions boolean {options_.operation, options_.priority, options_.fill};
        result_.parts = colorBoolean(result_.recovered, result_.network(), divided(), boolean,
                                     execution_);
        findSideAreas();
        addSideAreas();
        OverlayReport& report = result_.report;
        report.messages.insert(report.messages.end(), result_.parts.messages.begin(),
                               result_.parts.messages.end());
        if (result_.parts.parts.empty()) {
            std::vector<CurveId> parent;
            for (std::size_t c = 0; c < result_.network().curves.size(); ++c) {
                parent.push_back(result_.arranged ? result_.parent[c] : CurveId(c));
            }
            report.messages.push_back(whyEmpty(result_.recovered, result_.network(), divided(),
                                               boolean, {result_.input, parent, options_.weld},
                                               execution_));
        }
        for (const BooleanPart& part : result_.parts.parts) {
            report.area += part.area;
        }
        if (result_.input.operands.size() == 2) {
            report.theta = thetaAreas();
        }
        stopwatch_.lap(report.seconds.color);
    }

    /// What lies between a side and what it stands for: a contracted run, a curve.
    void findSideAreas()
    {
        std::vector<double> areas(divided().segments.size(), 0.0);
        if (contraction_) {
            areas = runAreas(*contraction_, result_.pslg);
        }
        if (options_.form == OverlayForm::Faces) {
            addCurveAreas(areas);
        }
        const Triangulation& t = result_.recovered.triangulation;
        const ConstraintMap& map = result_.recovered.constraints;
        for (std::uint32_t c = 0; c < areas.size(); ++c) {
            const auto chain = map.chainOf(ConstraintId(c));
            if (areas[c] == 0.0 || chain.size() < 2) {
                continue;
            }
            // Where several constraints stand for the same curve, it counts once.
            const auto uses = map.usesOf(*findSubsegment(map, chain[0], chain[1]));
            const auto first = std::find_if(uses.begin(), uses.end(), [&](const ConstraintUse& u) {
                return areas[u.constraint.index()] != 0.0;
            });
            const HalfEdge side = t.findEdge(chain[0], chain[1]);
            if (first->constraint == ConstraintId(c) && side != Topology::kDead) {
                sideAreas_.push_back({Topology::triangleOf(side), Topology::triangleOf(t.twin(side)),
                                      areas[c]});
            }
        }
    }

    void addCurveAreas(std::vector<double>& areas) const
    {
        std::size_t piece = 0;
        for (std::size_t s = 0; s < result_.pslg.segments.size(); ++s) {
            const PslgSegment& segment = result_.pslg.segments[s];
            const Curve* curve = result_.network().curves[segment.curve.index()].geometry.get();
            piece = !contraction_ ? s : piece + (contraction_->firstSegment[piece + 1] == s ? 1 : 0);
            if (curve != nullptr) {
                areas[piece] += chordArea(*curve, segment.ta, segment.tb);
            }
        }
    }

    void addSideAreas()
    {
        const auto add = [this](std::uint32_t triangle, double area) {
            const std::uint32_t part = result_.parts.partOfTriangle[triangle];
            if (part != BooleanParts::kNoPart) {
                result_.parts.parts[part].area += area;
            }
        };
        for (const SideArea& side : sideAreas_) {
            add(side.left, side.area);
            add(side.right, -side.area);
        }
    }

    ThetaAreas thetaAreas() const
    {
        const Triangulation& t = result_.recovered.triangulation;
        double area[4] = {};
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            if (t.isFinite(i)) {
                const auto& v = t.triangles[i].v;
                area[static_cast<std::size_t>(result_.parts.theta[i])] +=
                    0.5 * cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]);
            }
        }
        for (const SideArea& side : sideAreas_) {
            area[static_cast<std::size_t>(result_.parts.theta[side.left])] += side.area;
            area[static_cast<std::size_t>(result_.parts.theta[side.right])] -= side.area;
        }
        const Vec2 extent = result_.rectangle.corner[2] - result_.rectangle.corner[0];
        const auto of = [&area](Theta theta) { return area[static_cast<std::size_t>(theta)]; };
        ThetaAreas areas {of(Theta::O), of(Theta::T), of(Theta::S), 0.0};
        areas.e = extent.x * extent.y - areas.o - areas.t - areas.s;
        return areas;
    }

    void outlineStage()
    {
        execution_.beginStage("extract", 0.9, 1.0);
        result_.polygons = partOutlines(result_.recovered.triangulation,
                                        result_.parts.partOfTriangle, result_.parts.parts.size());
        if (contraction_) {
            expandResult();
        }
        stopwatch_.lap(result_.report.seconds.extract);
    }

    /// The triangles are those of the contraction: of no use to others.
    void expandResult()
    {
        ExpandedOverlay expanded = expand(*contraction_, result_.pslg, result_.recovered,
                                          vertexOfPoint_, result_.polygons);
        result_.recovered = std::move(expanded.recovered);
        result_.polygons = std::move(expanded.polygons);
        vertexOfPoint_ = std::move(expanded.vertexOfPoint);
        result_.parts.partOfTriangle.clear();
        result_.parts.theta.clear();
    }

    OverlayOptions options_;
    Execution& execution_;
    StageObserver* stages_;
    StageStopwatch stopwatch_;
    std::size_t firstCrossing_ = 0; ///< among the points of the arranged network
    std::optional<Contraction> contraction_;
    std::vector<SideArea> sideAreas_;
    DelaunayResult delaunay_;
    std::vector<std::uint32_t> vertexOfPoint_;
    OverlayResult result_;
};

} // namespace

std::vector<CurveId> OverlayResult::curvesOn(std::uint32_t a, std::uint32_t b) const
{
    const Subsegment* found = findSubsegment(recovered.constraints, a, b);
    std::vector<CurveId> curves;
    if (found == nullptr) {
        return curves;
    }
    for (const ConstraintUse& use : recovered.constraints.usesOf(*found)) {
        curves.push_back(inputCurveOf(use.constraint));
    }
    std::sort(curves.begin(), curves.end());
    curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
    return curves;
}

CurvesThroughVertices::CurvesThroughVertices(const OverlayResult& result)
{
    const std::size_t vertexCount = result.recovered.triangulation.points.size();
    std::vector<std::pair<std::uint32_t, CurveId>> pairs;
    for (std::size_t c = 0; c < result.pslg.segments.size(); ++c) {
        const CurveId curve = result.inputCurveOf(ConstraintId(c));
        for (const std::uint32_t v : result.recovered.constraints.chainOf(ConstraintId(c))) {
            pairs.emplace_back(v, curve);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    start_.assign(vertexCount + 1, 0);
    curves_.reserve(pairs.size());
    for (const auto& [v, curve] : pairs) {
        ++start_[v + 1];
        curves_.push_back(curve);
    }
    for (std::size_t v = 0; v < vertexCount; ++v) {
        start_[v + 1] += start_[v];
    }
}

OverlayResult overlayNetwork(CurveNetwork network, const OverlayOptions& options,
                             Execution& execution, StageObserver* stages)
{
    return Overlay(std::move(network), options, execution, stages).run();
}

} // namespace tessera
