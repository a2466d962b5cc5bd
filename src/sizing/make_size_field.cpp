// SPDX-License-Identifier: MIT
#include "sizing/make_size_field.h"

#include "base/error.h"
#include "curve/curve_tools.h"
#include "sizing/curve_sources.h"
#include "sizing/gap_sources.h"
#include "sizing/graded_size.h"
#include "sizing/min_size.h"
#include "sizing/uniform_size.h"

#include <cmath>
#include <limits>
#include <utility>

namespace tessera
{

namespace
{

/// A curve shorter than the size is one piece as long as the size on it is this much of its length
/// or less: see pieceCount(). Its own length need not be asked for then.
constexpr double kStillWhole = 1.25;
/// Greatest size of a field that something else bounds.
constexpr double kUnbounded = std::numeric_limits<double>::max();

void require(bool good, const char* message, std::vector<ErrorPlace> places = {})
{
    if (!good) {
        throw Error(ErrorKind::InvalidOption, message, std::move(places));
    }
}

bool isNumber(double x)
{
    return std::isfinite(x) && x >= 0.0;
}

void requireValid(const SizeLaw& law, std::vector<ErrorPlace> places)
{
    require(isNumber(law.size) && law.size > 0.0,
            "The size at a point or curve must be a number above 0.", places);
    require(isNumber(law.radius), "The distance up to which a size holds must not be negative.",
            places);
    const bool far = law.farSize != 0.0 || law.farRadius != 0.0;
    require(!far || (isNumber(law.farSize) && law.farSize >= law.size),
            "The size far from a point or curve must not be smaller than the size at it.", places);
    require(!far || (isNumber(law.farRadius) && law.farRadius > law.radius),
            "The distance of the far size must be greater than the distance of the near one.",
            places);
}

void requireValid(const LocalSizes& local, const CurveNetwork& network)
{
    require(local.piecesPerTurn >= 3.0 && local.piecesPerTurn <= 10000.0,
            "The pieces for a full turn must be between 3 and 10000.");
    require(isNumber(local.chordError), "The chord error must be a number above 0 (or 0 for none).");
    require(isNumber(local.gap) && local.gap <= 10000.0,
            "The number of elements across gaps must be between 0 and 10000.");
    for (const PointSize& point : local.points) {
        require(isFinite(point.position), "The place of a size is not finite.");
        requireValid(point.law, {{point.position}});
    }
    for (const CurveSize& curves : local.curves) {
        std::vector<ErrorPlace> places;
        for (const CurveId id : curves.curves) {
            require(id.index() < network.curves.size(), "A size is for a curve that is not there.");
            const NetworkCurve& curve = network.curves[id.index()];
            places.push_back({network.points[curve.start.index()], id.value});
        }
        requireValid(curves.law, std::move(places));
    }
}

void requireValid(const SizeOptions& options, const CurveNetwork& network)
{
    require(isNumber(options.size),
            "The size must be a number above 0 (or 0 to let it be chosen).");
    require(isNumber(options.minSize),
            "The smallest size must be a number above 0 (or 0 for none).");
    require(options.size == 0.0 || options.minSize <= options.size,
            "The smallest size is larger than the size; lower it or raise the size.");
    require(options.growth > 0.0 && options.growth <= 1.0,
            "The growth rate must be above 0 and at most 1.");
    requireValid(options.local, network);
}

SizeSource sourceOf(const SizeLaw& law)
{
    SizeSource source {{}, {}, law.size, law.radius};
    if (law.farRadius > 0.0) {
        source.slope = (law.farSize - law.size) / (law.farRadius - law.radius);
        source.most = law.farSize;
    }
    return source;
}

/// What the user asks for at points and curves.
std::vector<SizeSource> chosenSources(const CurveNetwork& network, const LocalSizes& local)
{
    std::vector<SizeSource> sources;
    for (const PointSize& point : local.points) {
        SizeSource source = sourceOf(point.law);
        source.a = source.b = point.position;
        sources.push_back(source);
    }
    for (const CurveSize& curves : local.curves) {
        for (const CurveId id : curves.curves) {
            addSourcesAlong(network, network.curves[id.index()], sourceOf(curves.law), sources);
        }
    }
    return sources;
}

/// Asked for what bends, is short or faces another curve.
std::vector<SizeSource> foundSources(const CurveNetwork& network, const SizeField& base,
                                     const SizeOptions& options, const Execution& execution)
{
    const LocalSizes& local = options.local;
    const CurveSourceOptions byCurve {local.piecesPerTurn, local.chordError, options.minSize};
    std::vector<SizeSource> sources =
        withoutDominated(curveSources(network, base, byCurve), options.growth, kStillWhole);
    if (local.gap > 0.0) {
        const GapOptions byGap {local.gap, options.minSize, options.inside};
        const std::vector<SizeSource> gaps = gapSources(network, base, byGap, execution);
        sources.insert(sources.end(), gaps.begin(), gaps.end());
    }
    return sources;
}

} // namespace

double defaultSize(const CurveNetwork& network)
{
    return networkBounds(network).diagonal() / 40.0;
}

std::unique_ptr<SizeField> makeSizeField(const CurveNetwork& network,
                                         std::shared_ptr<const SizeField> base,
                                         const SizeOptions& options, Execution& execution)
{
    requireValid(options, network);
    const Box2 box = networkBounds(network);
    if (!options.local.areas.empty() && !box.empty()) {
        const double uniform = base->uniformSize();
        const AreaSize::Options areaOptions {uniform > 0.0 ? uniform : kUnbounded, options.minSize,
                                             options.growth, options.inside};
        auto areas =
            std::make_shared<AreaSize>(box, options.local.areas, areaOptions, execution);
        if (uniform > 0.0) {
            base = std::move(areas);
        }
        else {
            base = std::make_shared<MinSize>(
                std::vector<std::shared_ptr<const SizeField>> {std::move(base), std::move(areas)});
        }
    }
    std::vector<SizeSource> sources = chosenSources(network, options.local);
    const std::vector<SizeSource> found = foundSources(network, *base, options, execution);
    sources.insert(sources.end(), found.begin(), found.end());
    const double uniform = base->uniformSize();
    if (sources.empty() && uniform > 0.0) {
        return std::make_unique<UniformSize>(uniform);
    }
    const GradedSize::Options gradedOptions {uniform > 0.0 ? uniform : kUnbounded, options.minSize,
                                             options.growth};
    std::vector<std::shared_ptr<const SizeField>> fields;
    if (!sources.empty()) {
        auto graded = std::make_unique<GradedSize>(box, sources, gradedOptions, execution);
        if (uniform > 0.0) {
            return graded;
        }
        fields.push_back(std::move(graded));
    }
    fields.push_back(std::move(base));
    return std::make_unique<MinSize>(std::move(fields));
}

std::unique_ptr<SizeField> makeSizeField(const CurveNetwork& network, const SizeOptions& options,
                                         Execution& execution)
{
    requireValid(options, network);
    double size = options.size > 0.0 ? options.size : defaultSize(network);
    if (!(size > 0.0)) {
        size = 1.0; // a network without extent: nothing will be meshed with it
    }
    return makeSizeField(network, std::make_shared<UniformSize>(size), options, execution);
}

} // namespace tessera
