// SPDX-License-Identifier: MIT
#include "region/no_inside.h"

#include "arrange/cross_curves.h"
#include "arrange/weld.h"
#include "base/number_text.h"
#include "curve/default_roles.h"
#include "region/curve_names.h"
#include "region/open_outline.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace tessera
{

namespace
{

constexpr const char* kBoundaryRole = " the role boundary (option 'boundary')";
constexpr const char* kOrFillAll =
    ", or choose the fill rule 'all', which meshes all that the curves enclose.";

bool bounds(const NetworkCurve& curve)
{
    return curve.role == Role::Boundary || curve.role == Role::Outline;
}

/// The curves of the input at these places were made constraints by the user or the file.
bool areConstraints(const std::vector<ErrorPlace>& places, const ArrangedInput& input)
{
    return std::all_of(places.begin(), places.end(), [&input](const ErrorPlace& place) {
        const NetworkCurve& curve = input.network.curves[input.parent[place.curve].index()];
        return curve.role == Role::Constraint && !curve.roleByConnection;
    });
}

Error openError(const OutlineFlaw& flaw, const ArrangedInput& input)
{
    const std::string role = areConstraints(flaw.places, input)
        ? std::string(", and give the curves") + kBoundaryRole
        : "";
    if (flaw.kind == OutlineFlaw::Kind::Gap) {
        return {ErrorKind::NoInside,
                "The outline is not closed: " + std::to_string(flaw.freeEnds)
                    + " ends are free. The two closest to each other are " + flaw.what + "; "
                    + flaw.remedy + role + ".",
                flaw.places};
    }
    return {ErrorKind::NoInside,
            "The ends of the curves close no outline: " + flaw.what + "; " + flaw.remedy + role
                + (flaw.meshedByAll() ? kOrFillAll : "."),
            flaw.places};
}

/// By curve of the input: its ends and those of others close an outline, but its role is another.
std::vector<std::uint8_t> takenByRole(const ArrangedInput& input, Role role)
{
    CurveNetwork network = input.network;
    const double tolerance = std::max(input.weld, meetingDistance(network, input.weld));
    const std::vector<std::uint8_t> all(network.points.size(), 1);
    const WeldResult weld = weldPoints(network.points, all, tolerance, Execution());
    for (NetworkCurve& curve : network.curves) {
        curve.start = PointId(weld.representative[curve.start.index()]);
        curve.end = PointId(weld.representative[curve.end.index()]);
        curve.role = Role::Chain;
    }
    settleChainRoles(network);
    std::vector<std::uint8_t> taken;
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        const NetworkCurve& given = input.network.curves[c];
        taken.push_back(bounds(network.curves[c]) && given.role == role && !given.roleByConnection);
    }
    return taken;
}

/// The roles leave no outline: which ones, if there would be one without them.
std::optional<Error> roleError(const ArrangedInput& input)
{
    for (const Role role : {Role::Constraint, Role::Ignored}) {
        const std::vector<std::uint8_t> taken = takenByRole(input, role);
        const NamedCurves names = namesOf(input.network, taken);
        if (names.empty()) {
            continue;
        }
        std::vector<ErrorPlace> places;
        for (std::uint32_t piece = 0; piece < input.parent.size(); ++piece) {
            const std::size_t c = input.parent[piece].index();
            if (taken[c] != 0 && (piece == 0 || input.parent[piece - 1] != input.parent[piece])) {
                places.push_back(
                    {input.network.points[input.network.curves[c].start.index()], piece});
            }
        }
        const bool one = names.names.size() + names.nameless == 1;
        const bool constraint = role == Role::Constraint;
        return Error(ErrorKind::NoInside,
                     "No outline is left: " + listOf(names)
                         + (one ? " closes one but has" : " close one but have") + " the role "
                         + (constraint ? "constraint" : "ignored") + "; give "
                         + (one ? "it" : "them") + kBoundaryRole
                         + (constraint ? kOrFillAll : "."),
                     std::move(places));
    }
    return std::nullopt;
}

ErrorPlace startOf(const CurveNetwork& network, bool (*wanted)(const NetworkCurve&))
{
    for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
        if (wanted(network.curves[c])) {
            return {network.points[network.curves[c].start.index()], c};
        }
    }
    return {};
}

bool hasFiniteTriangle(const Triangulation& t)
{
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (t.isFinite(i)) {
            return true;
        }
    }
    return false;
}

/// What the result would be without one of its possible reasons.
bool hasInside(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
               FillRule fill)
{
    Execution execution;
    return colorRegions(recovered, network, pslg, fill, execution).keptRegions > 0;
}

Error mergedError(const ArrangedInput& input, const ErrorPlace& place)
{
    return {ErrorKind::NoInside,
            "The outline encloses no area: curves of it lie within the weld tolerance "
                + numberText(input.weld)
                + " of each other and became one; choose a smaller tolerance.",
            {place}};
}

} // namespace

Error explainNoInside(const RecoveryResult& recovered, const CurveNetwork& network,
                      const Pslg& pslg, FillRule fill, const ArrangedInput& input)
{
    const auto any = [&network](auto wanted) {
        return std::any_of(network.curves.begin(), network.curves.end(), wanted);
    };
    if (!any(bounds)) {
        if (auto error = roleError(input)) {
            return *error;
        }
    }
    if (!any(isMeshed)) {
        return {ErrorKind::NoInside,
                "There are no curves, so there is nothing to mesh; draw a closed outline (or choose"
                " the fill rule 'hull' for points)."};
    }
    if (!hasFiniteTriangle(recovered.triangulation) || pslg.segments.empty()) {
        if (input.weldedAlong > 0) {
            return mergedError(input, startOf(network, isMeshed));
        }
        return {ErrorKind::NoInside,
                "The outline encloses no area: all its points lie on one line.",
                {startOf(network, isMeshed)}};
    }
    const auto flaw = findOutlineFlaw(recovered, network, pslg, input.parent, {});
    if (flaw && !any(bounds)) {
        return openError(*flaw, input);
    }
    const bool bySign = fill == FillRule::Positive || fill == FillRule::Negative;
    if (bySign && hasInside(recovered, network, pslg, FillRule::NonZero)) {
        const std::string way = fill == FillRule::Positive ? "clockwise" : "counter-clockwise";
        return {ErrorKind::NoInside,
                "Every outline runs " + way
                    + ", which this fill rule leaves out; choose 'even-odd' or 'nonzero'.",
                {startOf(network, bounds)}};
    }
    CurveNetwork withoutHoles = network;
    withoutHoles.holes.clear();
    if (!network.holes.empty() && hasInside(recovered, withoutHoles, pslg, fill)) {
        return {ErrorKind::NoInside,
                "The hole points leave nothing of the inside; remove the one that lies in the part"
                " to mesh.",
                {{network.holes.front().position}}};
    }
    if (flaw) {
        return openError(*flaw, input);
    }
    if (input.weldedAlong > 0) {
        return mergedError(input, startOf(network, bounds));
    }
    return {ErrorKind::NoInside,
            "The outline encloses no area: its parts are drawn twice or run back on themselves.",
            {startOf(network, bounds)}};
}

} // namespace tessera
