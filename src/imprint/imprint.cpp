// SPDX-License-Identifier: MIT
//
// Imprint for sweeping from several sources to several targets (the paper, section 4, leaves it to
// the Boolean algorithm): the cells of the overlay of all sources and targets, each with the set of
// operands that cover it, are the common refinement, and their sets are its history.
//
// What lies within the tolerance is found before welding, so that it can be reported, and closed by
// welding and by giving what is still narrow to a cell beside it. Narrow cells lie side by side only
// where they cross, so three rounds reach all of them; nothing moves by more than three times the
// tolerance, mostly by less than one.
#include "imprint/imprint.h"

#include "base/box2.h"
#include "base/error.h"
#include "curve/curve_tools.h"
#include "imprint/patches.h"
#include "imprint/true_area.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tessera
{

namespace
{

constexpr int kRounds = 3;
constexpr double kCoarseChord = 1e-5; ///< of the bounding box's diagonal, as for overlays
constexpr double kFineChord = 1e-6;   ///< no finer for any tolerance
constexpr double kChordOfTolerance = 0.01;

class Imprint
{
public:
    Imprint(const CurveNetwork& network, const std::vector<ImprintSide>& side,
            const ImprintOptions& options, Execution& execution)
        : network_(network)
        , side_(side)
        , options_(options)
        , execution_(execution)
    {
        std::uint32_t count[2] = {};
        for (const ImprintSide s : side) {
            number_.push_back(count[static_cast<std::size_t>(s)]++);
        }
        result_.cellsOfSource.resize(count[0]);
        result_.cellsOfTarget.resize(count[1]);
        result_.tolerance = options.tolerance;
    }

    ImprintResult run()
    {
        check();
        if (options_.tolerance > options_.weld) {
            unwelded_ = overlay(options_.weld);
            unweldedPatches_.emplace(*unwelded_);
            findNarrowOnes();
        }
        result_.overlay = overlay(std::max(options_.tolerance, options_.weld));
        closeNarrowOnes();
        listCells();
        listWhatIsLeft();
        addMessages();
        return std::move(result_);
    }

private:
    void check() const
    {
        if (side_.size() != network_.operands.size() || result_.cellsOfSource.empty()
            || result_.cellsOfTarget.empty()) {
            throw Error(ErrorKind::InvalidInput,
                        "An imprint needs a source and a target at least; give both.");
        }
        if (!(options_.tolerance >= 0.0) || !std::isfinite(options_.tolerance)) {
            throw Error(ErrorKind::InvalidOption,
                        "The tolerance of an imprint must be a length of 0 or more.");
        }
    }

    OverlayResult overlay(double weld)
    {
        OverlayOptions options;
        options.operation = BooleanOperation::Cells;
        options.fill = options_.fill;
        options.recovery = options_.recovery;
        options.weld = weld;
        options.chordError = options_.chordError;
        const Box2 box = networkBounds(network_);
        if (options.chordError == 0.0 && options_.tolerance > options_.weld
            && box.diagonal() > 0.0) {
            options.chordError = std::min(kCoarseChord * box.diagonal(),
                                          std::max(kChordOfTolerance * options_.tolerance,
                                                   kFineChord * box.diagonal()));
        }
        return overlayNetwork(network_, options, execution_);
    }

    void addOperands(const OverlayResult& overlay, std::uint32_t cell, Mismatch& mismatch) const
    {
        overlay.parts.sets.forEach(overlay.parts.parts[cell].operands, [&](OperandId operand) {
            const bool source = side_[operand.index()] == ImprintSide::Source;
            (source ? mismatch.sources : mismatch.targets).push_back(number_[operand.index()]);
        });
    }

    static void sortOut(std::vector<std::uint32_t>& numbers)
    {
        std::sort(numbers.begin(), numbers.end());
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    }

    /// Sources, targets and kind of a patch.
    Mismatch describe(const OverlayResult& overlay, const Patches& patches,
                      std::uint32_t patch) const
    {
        Mismatch mismatch;
        if (patches.isGap(patch)) {
            for (const Patches::Neighbor& neighbor : patches.neighborsOf(patch)) {
                if (neighbor.patch < patches.cellCount()) {
                    addOperands(overlay, neighbor.patch, mismatch);
                }
            }
            sortOut(mismatch.sources);
            sortOut(mismatch.targets);
            return mismatch;
        }
        addOperands(overlay, patch, mismatch);
        mismatch.kind = mismatch.sources.size() > 1 ? MismatchKind::SourceOverlap
            : mismatch.targets.size() > 1           ? MismatchKind::TargetOverlap
            : mismatch.targets.empty()              ? MismatchKind::SourceOnly
            : mismatch.sources.empty()              ? MismatchKind::TargetOnly
                                                    : MismatchKind::Sliver;
        return mismatch;
    }

    /// Gives whether it is no wider than the tolerance.
    bool measure(const Patches& patches, std::uint32_t patch, Mismatch& mismatch) const
    {
        const InscribedCircle circle = patches.circleIn(patch, 0.5 * options_.tolerance);
        mismatch.area = patches.area(patch);
        mismatch.width = 2.0 * circle.radius;
        mismatch.at = circle.center;
        return circle.isWithin;
    }

    /// Measured, if the patch is no wider than the tolerance.
    std::optional<Mismatch> ifNarrow(const OverlayResult& overlay, const Patches& patches,
                                     std::uint32_t patch) const
    {
        // No part of the plane is narrower than its area / perimeter.
        if (patches.area(patch) > options_.tolerance * patches.perimeter(patch)) {
            return std::nullopt;
        }
        Mismatch mismatch;
        if (!measure(patches, patch, mismatch)) {
            return std::nullopt;
        }
        Mismatch found = describe(overlay, patches, patch);
        found.area = mismatch.area;
        found.width = mismatch.width;
        found.at = mismatch.at;
        return found;
    }

    static bool hasCellBeside(const Patches& patches, std::uint32_t patch)
    {
        const auto neighbors = patches.neighborsOf(patch);
        return std::ranges::any_of(neighbors, [&](const Patches::Neighbor& neighbor) {
            return neighbor.patch < patches.cellCount();
        });
    }

    /// Before welding.
    void findNarrowOnes()
    {
        const Patches& patches = *unweldedPatches_;
        for (std::uint32_t p = 0; p < patches.size(); ++p) {
            execution_.checkpoint();
            if (auto mismatch = ifNarrow(*unwelded_, patches, p);
                mismatch && hasCellBeside(patches, p)) {
                result_.closed.push_back(std::move(*mismatch));
                unweldedNarrow_.push_back(p);
            }
        }
    }

    /// The patch that a narrow one joins: with one source and one target if there is such, of those
    /// the one with the longest common border.
    std::uint32_t heirOf(const Patches& patches, std::uint32_t patch,
                         const std::vector<std::uint32_t>& heir) const
    {
        std::uint32_t best = Patches::kOutside;
        std::pair<bool, double> bestRank {false, -1.0};
        for (const Patches::Neighbor& neighbor : patches.neighborsOf(patch)) {
            const std::uint32_t to =
                neighbor.patch == Patches::kOutside ? neighbor.patch : heir[neighbor.patch];
            if (to >= patches.cellCount()) {
                continue;
            }
            const bool proper =
                describe(result_.overlay, patches, to).kind == MismatchKind::Sliver;
            const std::pair rank(proper, neighbor.border);
            if (rank > bestRank) {
                bestRank = rank;
                best = to;
            }
        }
        return best;
    }

    void closeNarrowOnes()
    {
        const Patches patches(result_.overlay);
        std::vector<std::uint32_t> heir(patches.size()); ///< kOutside: none yet
        std::vector<std::pair<std::uint32_t, Mismatch>> narrow;
        for (std::uint32_t p = 0; p < patches.size(); ++p) {
            execution_.checkpoint();
            heir[p] = p;
            if (auto mismatch = ifNarrow(result_.overlay, patches, p)) {
                heir[p] = Patches::kOutside;
                narrow.emplace_back(p, std::move(*mismatch));
            }
        }
        for (int round = 0; round < kRounds; ++round) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> joins;
            for (const auto& [p, mismatch] : narrow) {
                if (heir[p] == Patches::kOutside) {
                    joins.emplace_back(p, heirOf(patches, p, heir));
                }
            }
            for (const auto& [p, to] : joins) {
                heir[p] = to;
            }
        }
        bool changed = false;
        for (const auto& [p, mismatch] : narrow) {
            if (heir[p] == Patches::kOutside) {
                heir[p] = p; // nothing wider beside it
                continue;
            }
            changed = true;
            noteClosed(patches, p, mismatch);
        }
        if (changed) {
            takeHeirs(patches, heir);
        }
    }

    /// Unless it is what welding has left of one that is on the list.
    void noteClosed(const Patches& patches, std::uint32_t patch, const Mismatch& mismatch)
    {
        for (std::size_t i = 0; i < unweldedNarrow_.size(); ++i) {
            if (patches.contains(patch, result_.closed[i].at)
                || unweldedPatches_->contains(unweldedNarrow_[i], mismatch.at)) {
                return;
            }
        }
        result_.closed.push_back(mismatch);
    }

    void takeHeirs(const Patches& patches, const std::vector<std::uint32_t>& heir)
    {
        OverlayResult& overlay = result_.overlay;
        std::vector<std::uint32_t> number(patches.cellCount(), BooleanParts::kNoPart);
        std::vector<BooleanPart> parts;
        for (std::uint32_t c = 0; c < patches.cellCount(); ++c) {
            if (heir[c] == c) {
                number[c] = static_cast<std::uint32_t>(parts.size());
                parts.push_back(overlay.parts.parts[c]);
                parts.back().area = 0.0;
            }
        }
        for (std::uint32_t p = 0; p < patches.size(); ++p) {
            const std::uint32_t part =
                heir[p] < patches.cellCount() ? number[heir[p]] : BooleanParts::kNoPart;
            for (const std::uint32_t t : patches.trianglesOf(p)) {
                overlay.parts.partOfTriangle[t] = part;
            }
            if (part != BooleanParts::kNoPart) {
                parts[part].area += patches.area(p);
            }
        }
        overlay.parts.parts = std::move(parts);
        overlay.polygons = partOutlines(overlay.recovered.triangulation,
                                        overlay.parts.partOfTriangle, overlay.parts.parts.size());
    }

    void listCells()
    {
        OverlayResult& overlay = result_.overlay;
        overlay.report.area = 0.0;
        for (std::uint32_t c = 0; c < overlay.parts.parts.size(); ++c) {
            Mismatch members;
            addOperands(overlay, c, members);
            for (const std::uint32_t source : members.sources) {
                result_.cellsOfSource[source].push_back(c);
            }
            for (const std::uint32_t target : members.targets) {
                result_.cellsOfTarget[target].push_back(c);
            }
            double& area = overlay.parts.parts[c].area;
            area = trueArea(overlay, c);
            overlay.report.area += area;
            result_.cells.push_back(
                {area, std::move(members.sources), std::move(members.targets)});
        }
    }

    void listWhatIsLeft()
    {
        const Patches patches(result_.overlay);
        std::vector<std::uint32_t> wide;
        for (std::uint32_t p = 0; p < patches.size(); ++p) {
            execution_.checkpoint();
            Mismatch mismatch = describe(result_.overlay, patches, p);
            const bool hole = mismatch.sources.size() < 2 && mismatch.targets.size() < 2;
            if (mismatch.kind == MismatchKind::Sliver
                || (mismatch.kind == MismatchKind::Gap && hole)) {
                continue;
            }
            measure(patches, p, mismatch);
            if (!patches.isGap(p)) {
                mismatch.area = result_.cells[p].area;
            }
            wide.push_back(p);
            result_.left.push_back(std::move(mismatch));
        }
        // Rounding at the very tolerance: what is left was not closed.
        std::erase_if(result_.closed, [&](const Mismatch& closed) {
            for (std::size_t i = 0; i < wide.size(); ++i) {
                if (result_.left[i].kind == closed.kind && result_.left[i].sources == closed.sources
                    && result_.left[i].targets == closed.targets
                    && patches.contains(wide[i], closed.at)) {
                    return true;
                }
            }
            return false;
        });
    }

    void addMessages()
    {
        result_.messages = result_.overlay.report.messages;
        const auto missing = [&](const auto& lists, const char* side) {
            for (std::size_t i = 0; i < lists.size(); ++i) {
                if (lists[i].empty()) {
                    result_.messages.push_back(
                        std::string(side) + ' ' + std::to_string(i + 1)
                        + " has no cell: it has no area, or is narrower than the tolerance.");
                }
            }
        };
        missing(result_.cellsOfSource, "Source");
        missing(result_.cellsOfTarget, "Target");
    }

    const CurveNetwork& network_;
    const std::vector<ImprintSide>& side_;
    ImprintOptions options_;
    Execution& execution_;
    std::vector<std::uint32_t> number_; ///< by operand: its number on its side
    /// Before welding, if it welds: where the overlaps and gaps are. The first entries of
    /// result_.closed are its narrow patches.
    std::optional<OverlayResult> unwelded_;
    std::optional<Patches> unweldedPatches_;
    std::vector<std::uint32_t> unweldedNarrow_;
    ImprintResult result_;
};

} // namespace

const char* nameOf(MismatchKind kind)
{
    switch (kind) {
        case MismatchKind::SourceOverlap:
            return "source overlap";
        case MismatchKind::TargetOverlap:
            return "target overlap";
        case MismatchKind::SourceOnly:
            return "source without target";
        case MismatchKind::TargetOnly:
            return "target without source";
        case MismatchKind::Gap:
            return "gap";
        case MismatchKind::Sliver:
            break;
    }
    return "sliver";
}

ImprintResult imprintNetwork(const CurveNetwork& network, const std::vector<ImprintSide>& side,
                             const ImprintOptions& options, Execution& execution)
{
    return Imprint(network, side, options, execution).run();
}

} // namespace tessera
