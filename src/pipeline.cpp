// SPDX-License-Identifier: MIT
#include "pipeline.h"

#include "arrange/arrange.h"
#include "curve/curve_tools.h"
#include "mesh/extract.h"
#include "mesh/second_order.h"
#include "optimize/optimize.h"
#include "refine/working_mesh.h"
#include "recover/snap_message.h"
#include "region/colored_plane.h"
#include "region/dropped_curves.h"
#include "region/no_inside.h"
#include "sample/sample.h"
#include "sizing/count_search.h"
#include "sizing/make_size_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

namespace tessera
{

namespace
{

/// Bytes that one triangle costs at the peak, all stages together; for the estimate only.
constexpr double kBytesPerTriangle = 250.0;

/// Pieces of curves are off by no more than this part of a narrow gap beside them. Without
/// refinement, which is for topology and speed, pieces need only not cross.
constexpr double kGapShare = 0.1;

void require(bool ok, const char* message)
{
    if (!ok) {
        throw Error(ErrorKind::InvalidOption, message);
    }
}

Box2 boundsOf(const std::vector<Vec2>& points)
{
    Box2 box;
    for (const Vec2 p : points) {
        box.add(p);
    }
    return box;
}

std::vector<ConstraintEnds> constraintEnds(const Pslg& pslg,
                                           const std::vector<std::uint32_t>& vertexOfPoint)
{
    std::vector<ConstraintEnds> ends;
    ends.reserve(pslg.segments.size());
    for (const PslgSegment& segment : pslg.segments) {
        ends.push_back({vertexOfPoint[segment.a.index()], vertexOfPoint[segment.b.index()]});
    }
    return ends;
}

/// What both recoveries did: of the straight curves among themselves, of all pieces.
RecoveryReport joined(const RecoveryReport& straight, RecoveryReport all)
{
    all.crossings += straight.crossings;
    all.touches += straight.touches;
    all.steinerInserted += straight.steinerInserted;
    all.steinerRemoved += straight.steinerRemoved;
    all.maxDisplacement = std::max(all.maxDisplacement, straight.maxDisplacement);
    all.snapPixel = std::max(all.snapPixel, straight.snapPixel);
    return all;
}

std::vector<VertexOrigin> vertexOrigins(const RecoveryResult& recovered, std::size_t networkPoints,
                                        std::size_t firstCrossing,
                                        const std::vector<std::uint32_t>& vertexOfPoint)
{
    const std::size_t count = recovered.triangulation.points.size();
    std::vector<VertexOrigin> origin(count, VertexOrigin::CurveSample);
    for (std::size_t p = networkPoints; p-- > 0;) {
        origin[vertexOfPoint[p]] = p < firstCrossing ? VertexOrigin::Input : VertexOrigin::Crossing;
    }
    for (std::size_t v = recovered.firstCrossing; v < count; ++v) {
        origin[v] = VertexOrigin::Crossing;
    }
    return origin;
}

/// Replaces the arranged curves that edges lie on by the input curves they are pieces of.
void nameCurvesOfInput(Mesh& mesh, const std::vector<CurveId>& parent)
{
    std::vector<CurveId> curves;
    std::vector<std::uint32_t> start {0};
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        std::set<CurveId> parents;
        for (std::uint32_t i = mesh.edgeCurveStart[e]; i < mesh.edgeCurveStart[e + 1]; ++i) {
            parents.insert(parent[mesh.edgeCurves[i].index()]);
        }
        curves.insert(curves.end(), parents.begin(), parents.end());
        start.push_back(static_cast<std::uint32_t>(curves.size()));
    }
    mesh.edgeCurves = std::move(curves);
    mesh.edgeCurveStart = std::move(start);
}

/// One meshing run: holds what a later stage needs of an earlier one.
class Run
{
public:
    Run(const CurveNetwork& input, const MeshOptions& options, Execution& execution,
        StageObserver* stages)
        : input_(input)
        , options_(options)
        , execution_(execution)
        , stages_(stages)
        , watch_(stages)
    {}

    MeshResult mesh(const SizeField* callersSize)
    {
        validate();
        arrangeStage();
        try {
            return meshArranged(callersSize);
        }
        catch (const Error& error) {
            if (error.kind() == ErrorKind::TimeLimit) {
                throw Error(ErrorKind::TimeLimit,
                            "The time limit ran out; raise it or choose a larger size.");
            }
            throw Error(error.kind(), error.what(), placesInInput(error.places()));
        }
    }

private:
    MeshResult meshArranged(const SizeField* callersSize)
    {
        const std::shared_ptr<const SizeField> field = sizeStage(callersSize);
        const SizeField& size = *field;
        refuseTooLarge(std::max(leastTriangles(), roughTriangles(size)));
        sampleStage(size);
        colored_.reset();
        triangulateStage();
        recoverStage();
        colorStage();
        refineStage(size);
        optimizeStage(size);
        extractStage(size);
        result_.report.seconds.total = watch_.total();
        return std::move(result_);
    }

    /// Errors of the later stages name arranged curves; the caller knows those of the input.
    std::vector<ErrorPlace> placesInInput(std::vector<ErrorPlace> places) const
    {
        for (ErrorPlace& place : places) {
            if (place.curve < arranged_.parent.size()) {
                place.curve = arranged_.parent[place.curve].value;
            }
        }
        return places;
    }

    void validate() const
    {
        const auto positive = [](double x) { return std::isfinite(x) && x >= 0.0; };
        require(positive(options_.size), "The size must be a positive length.");
        require(options_.count == 0 || options_.size == 0.0,
                "Give the size or the number of triangles, not both.");
        require(positive(options_.minSize), "The smallest size must be a positive length.");
        require(options_.growth > 0.0 && options_.growth <= 1.0,
                "The growth rate must lie above 0 and at most at 1.");
        require(options_.minAngle >= 0.0 && options_.minAngle <= 33.0,
                "The smallest angle must lie between 0 and 33 degrees.");
        require(positive(options_.maxArea), "The largest area must be positive.");
        require(positive(options_.narrowShare),
                "The share of triangles for narrow gaps must be a finite number of at least 0.");
        require(std::isfinite(options_.weld), "The weld tolerance must be a length.");
        require(options_.order == 1 || options_.order == 2, "The element order must be 1 or 2.");
    }

    void arrangeStage()
    {
        execution_.beginStage("arrange", 0.0, 0.05);
        MeshReport& report = result_.report;
        report.inputPoints = input_.points.size();
        for (const NetworkCurve& curve : input_.curves) {
            report.inputSegments += curve.geometry == nullptr ? 1 : 0;
        }
        report.inputCurves = input_.curves.size();
        report.inputOperands = input_.operands.size();
        ArrangeOptions arrangeOptions;
        arrangeOptions.weld = std::max(options_.weld, 0.0);
        // Without a tolerance the recovery of the pieces does it exactly.
        arrangeOptions.crossStraight = options_.refine || arrangeOptions.weld > 0.0;
        arrangeOptions.recovery = options_.recovery;
        arrangeOptions.observer = stages_;
        network_ = arrange(input_, arrangeOptions, arranged_, execution_);
        report.weld = arrangeOptions.weld;
        report.welded = arranged_.welded;
        report.messages = arranged_.messages;
        watch_.lap(report.seconds.arrange);
    }

    std::shared_ptr<const SizeField> sizeStage(const SizeField* callersSize)
    {
        SizeOptions sizeOptions {
            .size = options_.size, .minSize = options_.minSize, .growth = options_.growth};
        result_.report.defaultSize = defaultSize(network_);
        addLocalSizes(sizeOptions);
        if (callersSize == nullptr) {
            return makeSizeField(network_, sizeOptions, execution_);
        }
        // Not owned: the caller's field outlives the run.
        const std::shared_ptr<const SizeField> base(callersSize, [](const SizeField*) {});
        return makeSizeField(network_, base, sizeOptions, execution_);
    }

    void addLocalSizes(SizeOptions& sizeOptions)
    {
        LocalSizes& local = sizeOptions.local = options_.sizes;
        for (CurveSize& curves : local.curves) {
            curves.curves = arrangedCurves(curves.curves);
        }
        if (!options_.refine) {
            local.areas.clear(); // nothing but curved curves is divided
            local.regions.clear();
            local.gap = 0.0;
        }
        if (local.regions.empty() && local.areas.empty() && local.gap == 0.0) {
            return;
        }
        colored_ = std::make_unique<const ColoredPlane>(network_, options_.fill, execution_);
        sizeOptions.inside = [this](Vec2 p) { return colored_->regionAt(p).inside; };
        for (const RegionSize& region : local.regions) {
            local.areas.push_back(colored_->areaSource(region));
        }
        local.regions.clear();
    }

    /// The pieces of these curves of the input.
    std::vector<CurveId> arrangedCurves(const std::vector<CurveId>& ofInput) const
    {
        std::vector<std::uint8_t> chosen(input_.curves.size(), 0);
        for (const CurveId id : ofInput) {
            require(id.index() < chosen.size(), "A size is for a curve that is not there.");
            chosen[id.index()] = 1;
        }
        std::vector<CurveId> pieces;
        for (std::size_t c = 0; c < arranged_.parent.size(); ++c) {
            if (chosen[arranged_.parent[c].index()] != 0) {
                pieces.emplace_back(c);
            }
        }
        return pieces;
    }

    /// Every piece of a curve has a triangle of its own, and no size is larger than this one.
    double leastTriangles() const
    {
        const double largest = options_.size > 0.0 ? options_.size : result_.report.defaultSize;
        double length = 0.0;
        for (const NetworkCurve& curve : network_.curves) {
            length += isMeshed(curve) ? curveLength(network_, curve) : 0.0;
        }
        return options_.refine && largest > 0.0 ? std::min(length / largest, 1e300) : 0.0;
    }

    /// A quarter of what a look at a few places promises, for sizes so small that the curves alone
    /// would fill the memory; estimateTriangles() knows better later.
    double roughTriangles(const SizeField& size) const
    {
        if (size.uniformSize() > 0.0 || !options_.refine) {
            return 0.0;
        }
        double pieces = 0.0;
        constexpr int kPlaces = 4;
        for (const NetworkCurve& curve : network_.curves) {
            if (!isMeshed(curve)) {
                continue; // arrange() took its points away
            }
            const double length = curveLength(network_, curve);
            const Vec2 a = network_.points[curve.start.index()];
            const Vec2 b = network_.points[curve.end.index()];
            for (int i = 0; length > 0.0 && i < kPlaces; ++i) {
                const double share = (i + 0.5) / kPlaces;
                const Vec2 p = curve.geometry
                    ? curve.geometry->point(curve.geometry->first()
                                            + share
                                                * (curve.geometry->last() - curve.geometry->first()))
                    : a + share * (b - a);
                pieces += length / kPlaces / size.size(p);
            }
        }
        return 0.25 * (pieces + (colored_ ? roughInterior(size) : 0.0));
    }

    double roughInterior(const SizeField& size) const
    {
        constexpr int kPlaces = 64;
        const Box2 box = networkBounds(network_);
        const Vec2 step = 1.0 / kPlaces * (box.max - box.min);
        double triangles = 0.0;
        for (int i = 0; i < kPlaces * kPlaces; ++i) {
            const Vec2 p {box.min.x + (i % kPlaces + 0.5) * step.x,
                          box.min.y + (i / kPlaces + 0.5) * step.y};
            if (colored_->regionAt(p).inside) {
                const double h = size.size(p);
                triangles += 4.0 / std::numbers::sqrt3 * (step.x / h) * (step.y / h);
            }
        }
        return std::min(triangles, 1e300);
    }

    void sampleStage(const SizeField& size)
    {
        execution_.beginStage("sample", 0.05, 0.1);
        SampleOptions sampleOptions {.straightSegments = options_.refine && !options_.freezeBoundary,
                                     .piecesPerTurn = options_.sizes.piecesPerTurn,
                                     .chordError = options_.sizes.chordError,
                                     .gapShare = options_.refine ? kGapShare : 0.0,
                                     .growth = options_.growth};
        if (options_.memoryLimit > 0.0) {
            // Every piece has a triangle of its own.
            sampleOptions.mostPieces =
                std::min(kMostPieces, options_.memoryLimit / kBytesPerTriangle);
        }
        pslg_ = sample(network_, size, sampleOptions, execution_);
        tell(pslg_.messages);
        watch_.lap(result_.report.seconds.sample);
    }

    void triangulateStage()
    {
        execution_.beginStage("triangulate", 0.1, 0.2);
        rectangle_ = makeInitialRectangle(boundsOf(pslg_.points));
        delaunay_ = triangulate(pslg_.points, execution_);
        watch_.lap(result_.report.seconds.triangulate);
        if (stages_ != nullptr) {
            stages_->initialRectangle(rectangle_);
            stages_->pointsInserted(delaunay_.triangulation, rectangle_);
        }
    }

    void recoverStage()
    {
        execution_.beginStage("recover", 0.2, 0.35);
        const auto ends = constraintEnds(pslg_, delaunay_.vertexOfPoint);
        recovered_ = recoverBoundaries(std::move(delaunay_.triangulation), ends,
                                       options_.recovery, execution_, stages_);
        for (std::uint32_t& v : delaunay_.vertexOfPoint) {
            v = recovered_.vertexMap[v];
        }
        result_.report.recovery = joined(arranged_.crossed, recovered_.report);
        if (const std::string text = describeSnapping(result_.report.recovery); !text.empty()) {
            tell({text});
        }
        watch_.lap(result_.report.seconds.recover);
    }

    void colorStage()
    {
        execution_.beginStage("color", 0.35, 0.4);
        regions_ = colorRegions(recovered_, network_, pslg_, options_.fill, execution_);
        result_.report.regions = regions_.keptRegions;
        if (regions_.keptRegions == 0 && !allowsEmpty()) {
            requireNotSwallowed();
            throw explainNoInside(recovered_, network_, pslg_, options_.fill,
                                  ArrangedInput {input_, arranged_.parent, result_.report.weld,
                                                arranged_.weldedAlong});
        }
        tell(regions_.messages);
        tell(describeDroppedCurves(recovered_, network_, pslg_, regions_, arranged_.parent));
        watch_.lap(result_.report.seconds.color);
        if (stages_ != nullptr) {
            stages_->outsideRemoved(recovered_, regions_);
        }
        origin_ = vertexOrigins(recovered_, network_.points.size(), arranged_.firstCrossing,
                                delaunay_.vertexOfPoint);
        working_ = makeWorkingMesh(std::move(recovered_), regions_, network_, pslg_,
                                   std::move(origin_));
    }

    void tell(const std::vector<std::string>& messages)
    {
        result_.report.messages.insert(result_.report.messages.end(), messages.begin(),
                                       messages.end());
    }

    /// Throws if welding has left nothing but points of one line.
    void requireNotSwallowed() const
    {
        const Triangulation& t = recovered_.triangulation;
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            if (t.isFinite(i)) {
                return;
            }
        }
        if (result_.report.welded == 0) {
            return;
        }
        char text[256];
        std::snprintf(text, sizeof text,
                      "The weld tolerance of %.6g leaves nothing of the drawing, which measures "
                      "%.6g: it joined %zu of its %zu points to others. Choose a smaller tolerance.",
                      result_.report.weld, boundsOf(input_.points).diagonal(),
                      result_.report.welded, input_.points.size());
        throw Error(ErrorKind::InvalidOption, text, {{input_.points.front()}});
    }

    bool allowsEmpty() const
    {
        return options_.fill == FillRule::All || options_.fill == FillRule::Hull;
    }

    void refineStage(const SizeField& size)
    {
        if (!options_.refine || regions_.keptRegions == 0) {
            return;
        }
        execution_.beginStage("refine", 0.4, 0.75);
        refineOptions_.minAngle = options_.minAngle;
        refineOptions_.maxArea = options_.maxArea;
        refineOptions_.freezeBoundary = options_.freezeBoundary;
        refineOptions_.narrowShare = options_.narrowShare;
        refineOptions_.optimizeFollows = options_.optimize;
        for (const Region& region : regions_.regions) {
            refineOptions_.regionMaxArea.push_back(region.maxArea);
        }
        refineOptions_.maxTriangles = options_.memoryLimit / kBytesPerTriangle;
        if (options_.memoryLimit > 0.0) {
            refuseTooLarge(estimateTriangles(working_, size, refineOptions_));
        }
        RefineReport refined = refine(working_, size, refineOptions_, execution_);
        result_.report.unreached = std::move(refined.unreached);
        tell(refined.messages);
        watch_.lap(result_.report.seconds.refine);
    }

    void refuseTooLarge(double triangles) const
    {
        const double bytes = triangles * kBytesPerTriangle;
        if (options_.memoryLimit > 0.0 && bytes > options_.memoryLimit) {
            char text[256];
            std::snprintf(text, sizeof text,
                          "The mesh would have about %.3g triangles or more and need %.3g GB of "
                          "memory, but only %.3g GB are free; choose a larger size%s.",
                          triangles, bytes * 1e-9, options_.memoryLimit * 1e-9,
                          options_.maxArea > 0.0 ? " or a larger area" : "");
            throw Error(ErrorKind::TooLarge, text);
        }
    }

    void optimizeStage(const SizeField& size)
    {
        if (!options_.optimize || !options_.refine || regions_.keptRegions == 0) {
            return;
        }
        execution_.beginStage("optimize", 0.75, 0.95);
        OptimizeReport optimized = optimize(working_, size, refineOptions_, execution_);
        result_.report.unreached = std::move(optimized.unreached);
        watch_.lap(result_.report.seconds.optimize);
    }

    void extractStage(const SizeField& size)
    {
        execution_.beginStage("extract", 0.95, 1.0);
        ExtractResult extracted =
            extractMesh(working_, recovered_.constraints, regions_, pslg_, execution_);
        MeshReport& report = result_.report;
        Mesh& mesh = result_.mesh;
        mesh = std::move(extracted.mesh);
        execution_.checkpoint();
        report.quality = measureQuality(mesh, &size, execution_);
        execution_.checkpoint();
        if (options_.order == 2) {
            for (const std::uint32_t e : makeSecondOrder(mesh, extracted.edgeMiddle)) {
                report.unreached.push_back(
                    {"curved_edge", mesh.nodes[mesh.edgeMidNodes[e]], 0.0, 1.0});
            }
        }
        for (const CoarseGap& gap : pslg_.coarseGaps) {
            report.unreached.push_back({"gap", gap.place, gap.share, kGapShare});
        }
        nameCurvesOfInput(mesh, arranged_.parent);
        addGroups(mesh, input_, nodesOfInputPoints(extracted.nodeOfVertex));
        for (const Mesh::MeshRegion& region : mesh.regions) {
            report.regionAreas.push_back(region.area);
            report.area += region.area;
        }
        watch_.lap(report.seconds.extract);
        if (stages_ != nullptr) {
            stages_->optimized(mesh);
        }
    }

    /// By point of the input: its node, or kNoNode.
    std::vector<std::uint32_t> nodesOfInputPoints(const std::vector<std::uint32_t>& nodeOfVertex)
    {
        std::vector<std::uint32_t> nodes;
        nodes.reserve(arranged_.pointOf.size());
        for (const PointId point : arranged_.pointOf) {
            nodes.push_back(point.valid() ? nodeOfVertex[delaunay_.vertexOfPoint[point.index()]]
                                          : ExtractResult::kNoNode);
        }
        return nodes;
    }

    const CurveNetwork& input_;
    const MeshOptions& options_;
    Execution& execution_;
    StageObserver* stages_;
    StageStopwatch watch_;

    ArrangeReport arranged_;
    CurveNetwork network_; ///< arranged
    std::unique_ptr<const ColoredPlane> colored_; ///< where sizes need it
    Pslg pslg_;
    InitialRectangle rectangle_;
    DelaunayResult delaunay_;
    RecoveryResult recovered_;
    RegionMap regions_;
    std::vector<VertexOrigin> origin_;
    WorkingMesh working_;
    RefineOptions refineOptions_;
    MeshResult result_;
};

} // namespace

namespace
{

void addSeconds(StageSeconds& sum, const StageSeconds& s)
{
    for (const auto stage :
         {&StageSeconds::arrange, &StageSeconds::sample, &StageSeconds::triangulate,
          &StageSeconds::recover, &StageSeconds::color, &StageSeconds::refine,
          &StageSeconds::optimize, &StageSeconds::extract, &StageSeconds::total}) {
        sum.*stage += s.*stage;
    }
}

/// Meshes again and again until there are options.count triangles; the seconds are those of all
/// runs. stages sees one more run, with the size found.
MeshResult meshToCount(const CurveNetwork& network, const SizeField* size,
                       const MeshOptions& options, Execution& execution, StageObserver* stages)
{
    const Box2 box = networkBounds(network);
    MeshOptions trial = options;
    trial.count = 0;
    if (!(box.max.x > box.min.x && box.max.y > box.min.y)) {
        return Run(network, trial, execution, stages).mesh(size); // it says why nothing is inside
    }
    CountSearch search(static_cast<double>(options.count), box.max.x - box.min.x,
                       box.max.y - box.min.y, options.minSize);
    StageSeconds seconds;
    MeshResult best;
    int runs = 0;
    double begin = 0.0;
    const auto runOnce = [&](double h, StageObserver* observer) {
        // Nobody knows how many runs there will be: each has a third of what is left.
        const double end = begin + (1.0 - begin) / 3.0;
        execution.setShare(begin, end);
        begin = end;
        trial.size = std::max(h, options.minSize); // which it is, but for rounding
        MeshResult result = Run(network, trial, execution, observer).mesh(size);
        addSeconds(seconds, result.report.seconds);
        return result;
    };
    for (bool again = true; again && runs < CountSearch::kMostRuns; ++runs) {
        MeshResult result = runOnce(search.next(), nullptr);
        again = search.take(static_cast<double>(result.mesh.triangles.size()));
        if (search.isBest()) {
            best = std::move(result);
            best.report.count.size = trial.size;
        }
    }
    const double found = best.report.count.size;
    if (stages != nullptr) {
        best = runOnce(found, stages);
    }
    execution.setShare(0.0, 1.0);
    best.report.count = {options.count, found, runs};
    best.report.seconds = seconds;
    const auto made = static_cast<double>(best.mesh.triangles.size());
    if (!search.isReached(made)) {
        best.report.unreached.push_back({"count", midpoint(box.min, box.max), made,
                                         static_cast<double>(options.count)});
    }
    return best;
}

MeshResult meshOnceOrToCount(const CurveNetwork& network, const SizeField* size,
                             const MeshOptions& options, Execution& execution,
                             StageObserver* stages)
{
    return options.count > 0 && options.size == 0.0
        ? meshToCount(network, size, options, execution, stages)
        : Run(network, options, execution, stages).mesh(size);
}

} // namespace

MeshResult meshNetwork(const CurveNetwork& network, const MeshOptions& options,
                       Execution& execution, StageObserver* stages)
{
    return meshOnceOrToCount(network, nullptr, options, execution, stages);
}

MeshResult meshNetwork(const CurveNetwork& network, const SizeField& size,
                       const MeshOptions& options, Execution& execution, StageObserver* stages)
{
    return meshOnceOrToCount(network, &size, options, execution, stages);
}

} // namespace tessera
