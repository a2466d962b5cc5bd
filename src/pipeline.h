// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "delaunay/delaunay.h"
#include "mesh/mesh.h"
#include "mesh/quality.h"
#include "recover/recover.h"
#include "refine/refine.h"
#include "region/region.h"
#include "sizing/local_sizes.h"
#include "sizing/size_field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// Options of one meshing run. Lengths in the input's unit, angles in degrees. 0 means "choose".
struct MeshOptions
{
    double size = 0.0;     ///< target edge length; 0: bounding-box diagonal / 40
    std::size_t count = 0; ///< wanted number of triangles, instead of size; 0: size decides
    double minSize = 0.0;  ///< lower bound of the size field; 0: none
    double growth = 0.3;   ///< greatest |grad h|, 0 < growth <= 1
    double minAngle = 30.0; ///< 0..33
    double maxArea = 0.0;  ///< 0: none
    double weld = -1.0;    ///< end points closer than this are one; < 0: the input's default
    int order = 1;         ///< 1 or 2
    double memoryLimit = 0.0; ///< bytes; a mesh estimated to need more is refused; 0: no check
    FillRule fill = FillRule::EvenOdd;
    RecoveryStrategy recovery = RecoveryStrategy::Cavity;
    bool refine = true;    ///< false: no interior points, straight segments not sampled
    /// No new points on straight curves, on others only those that size and curvature ask for.
    bool freezeBoundary = false;
    /// Triangles that may be spent on gaps far narrower than the size, as a multiple of the others;
    /// 0 leaves them coarse. See RefineOptions::narrowShare.
    double narrowShare = kNarrowShare;
    bool optimize = true;
    LocalSizes sizes {};   ///< what asks for sizes besides size; curves by their ids in the input
};

/// Seconds of each stage; disjoint, in the order they run. read and write belong to the caller.
struct StageSeconds
{
    double read = 0, arrange = 0, sample = 0, triangulate = 0, recover = 0, color = 0, refine = 0,
           optimize = 0, extract = 0, write = 0, total = 0;
};

struct MeshReport
{
    std::size_t inputPoints = 0;
    std::size_t inputSegments = 0; ///< straight curves
    std::size_t inputCurves = 0;   ///< all curves
    std::size_t inputOperands = 0;
    RecoveryReport recovery;
    std::size_t regions = 0;
    double area = 0.0;
    std::vector<double> regionAreas;
    QualityReport quality;
    std::vector<Unreached> unreached;
    double defaultSize = 0.0; ///< diagonal / 40
    /// Only if MeshOptions::count was given: that, the size found for it, and after how many runs.
    struct Count
    {
        std::size_t target = 0;
        double size = 0.0;
        int runs = 0;
    } count;
    double weld = 0.0;        ///< the tolerance used
    std::size_t welded = 0;   ///< end points joined by it to others, or to curves
    std::vector<std::string> messages; ///< for the user: holes by even-odd, welds, narrow gaps, ...
    StageSeconds seconds;
};

struct MeshResult
{
    Mesh mesh;
    MeshReport report;
};

/// Called after each stage of the paper's Fig. 2 with what a picture needs; see io/stage_pictures.
/// Boundaries are recovered twice: the straight curves among themselves before sampling, then all
/// pieces.
struct StageObserver: RecoveryObserver
{
    virtual void initialRectangle(const InitialRectangle& rectangle) = 0;
    virtual void pointsInserted(const Triangulation&, const InitialRectangle&) = 0;
    virtual void outsideRemoved(const RecoveryResult&, const RegionMap&) = 0;
    virtual void optimized(const Mesh&) = 0;
    /// Seconds that the calls took so far; they count for no stage.
    virtual double seconds() const { return 0.0; }
};

/// Adds the time since the last call to a stage. Stands still while the observer is at work.
class StageStopwatch
{
public:
    explicit StageStopwatch(const StageObserver* observer)
        : observer_(observer)
        , beforeObserver_(observed())
    {}

    void lap(double& stage)
    {
        const double now = total();
        stage += now - last_;
        last_ = now;
    }
    double total() const
    {
        const auto elapsed = Execution::Clock::now() - begin_;
        return std::chrono::duration<double>(elapsed).count() - (observed() - beforeObserver_);
    }

private:
    double observed() const { return observer_ == nullptr ? 0.0 : observer_->seconds(); }

    const StageObserver* observer_;
    double beforeObserver_;
    Execution::Clock::time_point begin_ = Execution::Clock::now();
    double last_ = 0.0;
};

/// The stages in order: arrange, sample, triangulate, recover, color, refine, optimize, extract
/// (paper, Algorithm 1). Each is also callable alone. Throws Error; on failure nothing is left.
MeshResult meshNetwork(const CurveNetwork& network, const MeshOptions& options,
                       Execution& execution, StageObserver* stages = nullptr);

/// As above with a size field of the caller's besides options.size; the smaller one counts.
MeshResult meshNetwork(const CurveNetwork& network, const SizeField& size,
                       const MeshOptions& options, Execution& execution,
                       StageObserver* stages = nullptr);

} // namespace tessera
