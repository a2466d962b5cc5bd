// SPDX-License-Identifier: MIT
#include "region/open_outline.h"

#include "base/number_text.h"
#include "curve/default_roles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

namespace tessera
{

namespace
{

constexpr double kFar = std::numeric_limits<double>::infinity();

/// One end of a subsegment, for one curve of the input that runs along it.
struct Incidence
{
    std::uint32_t operand;
    std::uint32_t vertex;
    std::uint32_t parent;
    std::uint32_t subsegment;
    std::uint32_t curve;

    auto key() const { return std::tie(operand, vertex, parent, subsegment, curve); }
};

/// Where an odd number of an operand's curves end.
struct FreeEnd
{
    std::uint32_t operand;
    std::uint32_t vertex;
    std::uint32_t parent;
    std::uint32_t curve;
    bool onOther; ///< another curve runs through
};

/// Where two curves meet other than at ends of both.
struct Meeting
{
    OutlineFlaw::Kind kind;
    std::uint32_t vertex;
    std::uint32_t parentA; ///< of a touch or an overlap: the one that ends
    std::uint32_t curveA;
    std::uint32_t parentB;
    std::uint32_t curveB;

    std::pair<std::uint32_t, std::uint32_t> parents() const
    {
        return std::minmax(parentA, parentB);
    }
};

/// The curves as a graph of subsegments, each operand for itself or all as one.
class OutlineGraph
{
public:
    OutlineGraph(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
                 std::span<const CurveId> parent, std::span<const std::uint8_t> wanted,
                 bool joinOperands)
        : recovered_(recovered)
        , network_(network)
        , pslg_(pslg)
        , parent_(parent)
        , wanted_(wanted)
        , joinOperands_(joinOperands)
    {
        collectIncidences();
        lookAtVertices();
        findCycles();
    }

    bool encloses() const { return encloses_; }
    const std::vector<FreeEnd>& freeEnds() const { return freeEnds_; }
    const std::vector<Meeting>& meetings() const { return meetings_; }
    const std::vector<Incidence>& incidences() const { return incidences_; }

private:
    std::uint32_t parentOf(std::uint32_t curve) const
    {
        return curve < parent_.size() ? parent_[curve].value : curve;
    }

    bool isWanted(std::uint32_t curve) const
    {
        return wanted_.empty() || wanted_[curve] != 0;
    }

    void collectIncidences()
    {
        const auto& subsegments = recovered_.constraints.subsegments;
        for (std::uint32_t s = 0; s < subsegments.size(); ++s) {
            for (const ConstraintUse& use : recovered_.constraints.usesOf(subsegments[s])) {
                const std::uint32_t curve = pslg_.segments[use.constraint.index()].curve.value;
                const std::uint32_t operand =
                    joinOperands_ ? 0 : network_.curves[curve].operand.value;
                for (const std::uint32_t v : {subsegments[s].a, subsegments[s].b}) {
                    incidences_.push_back({operand, v, parentOf(curve), s, curve});
                }
            }
        }
        std::sort(incidences_.begin(), incidences_.end(),
                  [](const Incidence& a, const Incidence& b) { return a.key() < b.key(); });
    }

    /// Incidences [begin, end) have one operand and one vertex.
    void lookAtVertices()
    {
        groupOf_.resize(incidences_.size());
        for (std::size_t i = 0; i < incidences_.size(); ++groups_) {
            std::size_t j = i;
            for (; j < incidences_.size() && incidences_[j].operand == incidences_[i].operand
                 && incidences_[j].vertex == incidences_[i].vertex;
                 ++j) {
                groupOf_[j] = groups_;
            }
            lookAtVertex(i, j);
            i = j;
        }
    }

    void lookAtVertex(std::size_t begin, std::size_t end)
    {
        std::vector<std::size_t> ending;
        std::vector<std::size_t> through; // twice for a curve that passes twice
        for (std::size_t i = begin; i < end;) {
            std::size_t j = i;
            while (j < end && incidences_[j].parent == incidences_[i].parent) {
                ++j;
            }
            if ((j - i) % 2 == 1) {
                ending.push_back(i);
            }
            through.insert(through.end(), (j - i) / 2, i);
            i = j;
        }
        if (ending.size() % 2 == 1 && isWanted(incidences_[ending[0]].curve)) {
            const Incidence& e = incidences_[ending[0]];
            freeEnds_.push_back({e.operand, e.vertex, e.parent, e.curve, !through.empty()});
            if (!through.empty()) {
                addTouch(e, begin, end, incidences_[through[0]]);
            }
        }
        for (std::size_t k = 1; k < through.size(); ++k) {
            addMeeting(OutlineFlaw::Kind::Crossing, incidences_[through[k - 1]],
                       incidences_[through[k]]);
        }
    }

    /// A curve's end on a curve that runs through; if they share the subsegment, an overlap.
    void addTouch(const Incidence& e, std::size_t begin, std::size_t end, const Incidence& other)
    {
        for (std::size_t i = begin; i < end; ++i) {
            if (incidences_[i].subsegment == e.subsegment && incidences_[i].parent != e.parent) {
                addMeeting(OutlineFlaw::Kind::Overlap, e, incidences_[i]);
                return;
            }
        }
        addMeeting(OutlineFlaw::Kind::Touch, e, other);
    }

    void addMeeting(OutlineFlaw::Kind kind, const Incidence& a, const Incidence& b)
    {
        if (isWanted(a.curve) || isWanted(b.curve)) {
            meetings_.push_back({kind, a.vertex, a.parent, a.curve, b.parent, b.curve});
        }
    }

    /// Some wanted piece is left when dangling trees are taken off.
    void findCycles()
    {
        std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> ends;
        for (std::size_t i = 0; i < incidences_.size(); ++i) {
            ends.emplace_back(incidences_[i].operand, incidences_[i].subsegment, groupOf_[i]);
        }
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        std::vector<GraphEdge> edges;
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
            edges.push_back({std::get<2>(ends[i]), std::get<2>(ends[i + 1])});
        }
        const EdgeClasses classes = classifyEdges(edges, groups_, {});
        std::vector<std::pair<std::uint32_t, std::uint32_t>> onCycles; // ascending
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (classes.classOf[e] != EdgeClass::Dangling) {
                onCycles.emplace_back(std::get<0>(ends[2 * e]), std::get<1>(ends[2 * e]));
            }
        }
        encloses_ = std::any_of(incidences_.begin(), incidences_.end(), [&](const Incidence& i) {
            return isWanted(i.curve)
                && std::binary_search(onCycles.begin(), onCycles.end(),
                                      std::pair(i.operand, i.subsegment));
        });
    }

    const RecoveryResult& recovered_;
    const CurveNetwork& network_;
    const Pslg& pslg_;
    std::span<const CurveId> parent_;
    std::span<const std::uint8_t> wanted_;
    bool joinOperands_;
    std::vector<Incidence> incidences_;
    std::vector<std::uint32_t> groupOf_; ///< by incidence: its operand and vertex, counted
    std::uint32_t groups_ = 0;
    std::vector<FreeEnd> freeEnds_;
    std::vector<Meeting> meetings_;
    bool encloses_ = false;
};

class FlawFinder
{
public:
    FlawFinder(const OutlineGraph& graph, const RecoveryResult& recovered,
               const CurveNetwork& network)
        : graph_(graph)
        , points_(recovered.triangulation.points)
        , network_(network)
    {
        for (const Meeting& m : graph.meetings()) {
            meet_.insert(m.parents());
        }
        byParent_ = graph.freeEnds();
        std::stable_sort(byParent_.begin(), byParent_.end(), isOfLowerParent);
    }

    std::optional<OutlineFlaw> find() const
    {
        if (graph_.freeEnds().empty()) {
            return std::nullopt;
        }
        const auto gap = closestEnds();
        if (!graph_.encloses()) {
            return gap ? std::optional(describeGap(*gap)) : std::nullopt;
        }
        const Meeting* best = nullptr;
        double least = kFar;
        for (const Meeting& m : graph_.meetings()) {
            const double length = m.kind == OutlineFlaw::Kind::Overlap ? -1.0 : overshoot(m);
            if (best == nullptr || length < least) {
                best = &m;
                least = length;
            }
        }
        if (gap && (best == nullptr || lengthOf(*gap) <= least)) {
            return describeGap(*gap);
        }
        return best != nullptr ? std::optional(describe(*best)) : std::nullopt;
    }

    OutlineFlaw describeOperands(const FreeEnd& a, const FreeEnd& b) const
    {
        OutlineFlaw flaw = describeNothing(OutlineFlaw::Kind::Operands);
        const auto [nameA, nameB] = names(a.curve, b.curve);
        flaw.what = (nameA.empty() ? "curves" : nameA + " and " + nameB) + " meet at "
            + place(a.vertex) + " but belong to different sources";
        flaw.remedy = "put all curves of one outline into one source";
        flaw.places = {{points_[a.vertex], a.curve}, {points_[b.vertex], b.curve}};
        return flaw;
    }

private:
    static bool isOfLowerParent(const FreeEnd& a, const FreeEnd& b) { return a.parent < b.parent; }

    using Pair = std::pair<FreeEnd, FreeEnd>;

    double lengthOf(const Pair& pair) const
    {
        return distance(points_[pair.first.vertex], points_[pair.second.vertex]);
    }

    /// Of one operand, on no other curve; and not of two curves that meet, if the curves enclose
    /// something: then it is these that are to be trimmed.
    std::optional<Pair> closestEnds() const
    {
        std::vector<FreeEnd> ends;
        for (const FreeEnd& end : graph_.freeEnds()) {
            if (!end.onOther) {
                ends.push_back(end);
            }
        }
        const auto x = [this](const FreeEnd& end) { return points_[end.vertex].x; };
        std::stable_sort(ends.begin(), ends.end(), [&x](const FreeEnd& a, const FreeEnd& b) {
            return std::pair(a.operand, x(a)) < std::pair(b.operand, x(b));
        });
        double nearest = kFar;
        std::optional<Pair> best;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = i + 1; j < ends.size() && ends[j].operand == ends[i].operand
                 && x(ends[j]) - x(ends[i]) < nearest;
                 ++j) {
                const bool trimmed = graph_.encloses()
                    && meet_.contains(std::minmax(ends[i].parent, ends[j].parent));
                const Pair pair(ends[i], ends[j]);
                if (!trimmed && lengthOf(pair) < nearest) {
                    nearest = lengthOf(pair);
                    best = pair;
                }
            }
        }
        return best;
    }

    /// How far the curves that run through go on at least to a free end.
    double overshoot(const Meeting& m) const
    {
        const double ofB = toFreeEnd(m.parentB, m.vertex);
        return m.kind == OutlineFlaw::Kind::Crossing ? std::min(ofB, toFreeEnd(m.parentA, m.vertex))
                                                     : ofB;
    }

    double toFreeEnd(std::uint32_t parent, std::uint32_t vertex) const
    {
        const auto [begin, end] = std::equal_range(byParent_.begin(), byParent_.end(),
                                                   FreeEnd {0, 0, parent, 0, false},
                                                   isOfLowerParent);
        double least = kFar;
        for (auto e = begin; e != end; ++e) {
            if (e->vertex != vertex) {
                least = std::min(least, distance(points_[vertex], points_[e->vertex]));
            }
        }
        return least;
    }

    std::string place(std::uint32_t vertex,
                      double apart = std::numeric_limits<double>::infinity()) const
    {
        const Vec2 p = points_[vertex];
        const double rounding = 1e-14 * (std::abs(p.x) + std::abs(p.y));
        return placeText({std::abs(p.x) > rounding ? p.x : 0.0,
                          std::abs(p.y) > rounding ? p.y : 0.0},
                         apart);
    }

    std::string nameOf(std::uint32_t curve) const
    {
        return curve < network_.curveNames.size() ? network_.curveNames[curve] : std::string();
    }

    /// Both, or none.
    std::pair<std::string, std::string> names(std::uint32_t a, std::uint32_t b) const
    {
        return nameOf(a).empty() || nameOf(b).empty() ? std::pair<std::string, std::string>()
                                                      : std::pair(nameOf(a), nameOf(b));
    }

    OutlineFlaw describeNothing(OutlineFlaw::Kind kind) const
    {
        return {kind, {}, {}, {}, graph_.freeEnds().size()};
    }

    OutlineFlaw describeGap(const Pair& pair) const
    {
        OutlineFlaw flaw = describeNothing(OutlineFlaw::Kind::Gap);
        const double gap = lengthOf(pair);
        const auto end = [this, gap](const FreeEnd& e) {
            return place(e.vertex, gap) + (nameOf(e.curve).empty() ? "" : " of " + nameOf(e.curve));
        };
        flaw.what = end(pair.first) + " and " + end(pair.second) + ", " + numberText(gap) + " apart";
        flaw.remedy = "close the gap, or raise the weld tolerance to that";
        flaw.places = {{points_[pair.first.vertex], pair.first.curve},
                       {points_[pair.second.vertex], pair.second.curve}};
        return flaw;
    }

    OutlineFlaw describe(const Meeting& m) const
    {
        OutlineFlaw flaw = describeNothing(m.kind);
        flaw.places = {{points_[m.vertex], m.curveA}, {points_[m.vertex], m.curveB}};
        const auto both = names(m.curveA, m.curveB);
        const std::string& a = both.first;
        const std::string& b = both.second;
        const bool itself = m.parentA == m.parentB || (!a.empty() && a == b);
        const auto say = [&](const char* one, const char* two, const char* nameless) {
            flaw.what = a.empty() ? nameless : itself ? a + one : a + two;
        };
        const std::string at = " at " + place(m.vertex);
        switch (m.kind) {
            case OutlineFlaw::Kind::Overlap:
                say(" overlaps itself", (" and " + b + " overlap").c_str(), "curves overlap");
                flaw.what += extentOf(m, flaw);
                flaw.remedy = "let one end where the other begins";
                break;
            case OutlineFlaw::Kind::Touch:
                say(" ends on its own inside", (" ends on the inside of " + b).c_str(),
                    "a curve ends on the inside of another one");
                flaw.what += at;
                flaw.remedy = "let both end there";
                break;
            default:
                say(" crosses itself", (" and " + b + " cross").c_str(), "curves cross");
                flaw.what += at;
                flaw.remedy = "let them end there";
                break;
        }
        return flaw;
    }

    /// Where the overlap begins and ends, if both are ends of one of the two curves.
    std::string extentOf(const Meeting& m, OutlineFlaw& flaw) const
    {
        for (const Meeting& other : graph_.meetings()) {
            if (other.kind == m.kind && other.vertex != m.vertex
                && other.parents() == m.parents()) {
                flaw.places[1].position = points_[other.vertex];
                const double apart = distance(points_[m.vertex], points_[other.vertex]);
                return " between " + place(m.vertex, apart) + " and " + place(other.vertex, apart);
            }
        }
        return " beside " + place(m.vertex);
    }

    const OutlineGraph& graph_;
    const std::vector<Vec2>& points_;
    const CurveNetwork& network_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> meet_;
    std::vector<FreeEnd> byParent_;
};

/// Two free ends of different operands in one place.
std::optional<std::pair<FreeEnd, FreeEnd>> commonEnd(std::vector<FreeEnd> ends)
{
    std::stable_sort(ends.begin(), ends.end(), [](const FreeEnd& a, const FreeEnd& b) {
        return a.vertex < b.vertex;
    });
    for (std::size_t i = 1; i < ends.size(); ++i) {
        if (ends[i].vertex == ends[i - 1].vertex) {
            return std::pair(ends[i - 1], ends[i]);
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<OutlineFlaw> findOutlineFlaw(const RecoveryResult& recovered,
                                           const CurveNetwork& network, const Pslg& pslg,
                                           std::span<const CurveId> parent,
                                           std::span<const std::uint8_t> wanted)
{
    const OutlineGraph graph(recovered, network, pslg, parent, wanted, false);
    const FlawFinder finder(graph, recovered, network);
    if (!graph.encloses()) {
        const auto common = commonEnd(graph.freeEnds());
        if (common && OutlineGraph(recovered, network, pslg, parent, wanted, true).encloses()) {
            return finder.describeOperands(common->first, common->second);
        }
    }
    return finder.find();
}

} // namespace tessera
