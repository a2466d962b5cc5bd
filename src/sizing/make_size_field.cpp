// SPDX-License-Identifier: MIT
#include "sizing/make_size_field.h"

#include "base/error.h"
#include "curve/curve_tools.h"
#include "sizing/curve_sources.h"
#include "sizing/graded_size.h"
#include "sizing/min_size.h"
#include "sizing/uniform_size.h"

#include <cmath>
#include <limits>

namespace tessera
{

namespace
{

/// A curve shorter than the size is one piece as long as the size on it is this much of its length
/// or less: see pieceCount(). Its own length need not be asked for then.
constexpr double kStillWhole = 1.25;

void require(bool good, const char* message)
{
    if (!good) {
        throw Error(ErrorKind::InvalidOption, message);
    }
}

void requireValid(const SizeOptions& options)
{
    require(std::isfinite(options.size) && options.size >= 0.0,
            "The size must be a number above 0 (or 0 to let it be chosen).");
    require(std::isfinite(options.minSize) && options.minSize >= 0.0,
            "The smallest size must be a number above 0 (or 0 for none).");
    require(options.size == 0.0 || options.minSize <= options.size,
            "The smallest size is larger than the size; lower it or raise the size.");
    require(options.growth > 0.0 && options.growth <= 1.0,
            "The growth rate must be above 0 and at most 1.");
    require(options.piecesPerTurn >= 3.0 && options.piecesPerTurn <= 10000.0,
            "The pieces for a full turn must be between 3 and 10000.");
    require(std::isfinite(options.chordError) && options.chordError >= 0.0,
            "The chord error must be a number above 0 (or 0 for none).");
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
    requireValid(options);
    const CurveSourceOptions sourceOptions {options.piecesPerTurn, options.chordError,
                                            options.minSize};
    const std::vector<SizeSource> sources =
        withoutDominated(curveSources(network, *base, sourceOptions), options.growth, kStillWhole);
    const double uniform = base->uniformSize();
    if (sources.empty() && uniform > 0.0) {
        return std::make_unique<UniformSize>(uniform);
    }
    const Box2 box = networkBounds(network);
    const double largest = uniform > 0.0 ? uniform : std::numeric_limits<double>::max();
    const GradedSize::Options gradedOptions {largest, options.minSize, options.growth};
    auto graded = std::make_unique<GradedSize>(box, sources, gradedOptions, execution);
    if (uniform > 0.0) {
        return graded;
    }
    std::vector<std::shared_ptr<const SizeField>> fields {std::move(base), std::move(graded)};
    return std::make_unique<MinSize>(std::move(fields));
}

std::unique_ptr<SizeField> makeSizeField(const CurveNetwork& network, const SizeOptions& options,
                                         Execution& execution)
{
    requireValid(options);
    double size = options.size > 0.0 ? options.size : defaultSize(network);
    if (!(size > 0.0)) {
        size = 1.0; // a network without extent: nothing will be meshed with it
    }
    return makeSizeField(network, std::make_shared<UniformSize>(size), options, execution);
}

} // namespace tessera
