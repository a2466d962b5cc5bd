// SPDX-License-Identifier: MIT
//
// Triangles are taken from the border inwards, one at a time, while what is left stays a disc: a
// triangle goes only if the corner opposite to its side on the border is not on the border itself.
// That corner then lies on the border with triangles behind it, so no vertex loses its last
// triangle; and since a constraint on the border is never passed, no constraint loses its last one.
#include "region/hull_slivers.h"

#include "predicates/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera
{

namespace
{

/// Of the greatest coordinate: twice what LineCurve::point() may be off its line, and some more.
constexpr double kFlat = 16.0 * std::numeric_limits<double>::epsilon();

bool isStraight(const NetworkCurve& curve)
{
    const Curve* geometry = curve.geometry.get();
    return geometry == nullptr
        || (geometry->breaks().empty()
            && geometry->secondDerivativeBound(geometry->first(), geometry->last()) == 0.0);
}

class HullSlivers
{
public:
    HullSlivers(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg)
        : t_(recovered.triangulation)
        , straight_(std::all_of(network.curves.begin(), network.curves.end(), isStraight))
    {
        markMade(recovered, network, pslg);
        for (std::size_t v = 1; v < t_.points.size(); ++v) {
            flat_ = std::max({flat_, kFlat * std::fabs(t_.points[v].x),
                              kFlat * std::fabs(t_.points[v].y)});
        }
    }

    std::vector<std::uint32_t> run()
    {
        if (std::count(made_.begin(), made_.end(), 1) == 0) {
            return {};
        }
        if (straight_ && givenAreCollinear()) {
            return allFinite();
        }
        takeFromBorder();
        return std::move(taken_);
    }

private:
    /// Samples, and where a curve touches another one. Straight curves that cross do so inside the
    /// hull of their ends.
    void markMade(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg)
    {
        made_.assign(t_.points.size(), 0);
        const std::size_t inputs = std::min(network.firstCrossing, network.points.size());
        const std::size_t given = straight_ ? network.points.size() : inputs;
        const auto forEachEnd = [&](auto f) {
            for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
                const auto chain = recovered.constraints.chainOf(ConstraintId(s));
                f(pslg.segments[s].a, chain.front());
                f(pslg.segments[s].b, chain.back());
            }
        };
        forEachEnd([&](PointId p, std::uint32_t v) {
            made_[v] = p.index() >= given ? 1 : made_[v];
        });
        forEachEnd([&](PointId p, std::uint32_t v) {
            made_[v] = p.index() < given ? 0 : made_[v];
        });
    }

    bool givenAreCollinear() const
    {
        std::vector<Vec2> given;
        for (std::size_t v = 1; v < t_.points.size(); ++v) {
            if (made_[v] == 0) {
                given.push_back(t_.points[v]);
            }
        }
        return std::all_of(given.begin(), given.end(), [&given](Vec2 p) {
            return orient2d(given.front(), given.back(), p) == 0;
        });
    }

    std::vector<std::uint32_t> allFinite() const
    {
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t t = 0; t < t_.triangles.size(); ++t) {
            if (t_.isFinite(t)) {
                triangles.push_back(t);
            }
        }
        return triangles;
    }

    void takeFromBorder()
    {
        onBorder_.assign(t_.points.size(), 0);
        std::vector<HalfEdge> border; // of the triangles that are left
        for (std::uint32_t t = 0; t < t_.triangles.size(); ++t) {
            for (std::uint32_t i = 0; t_.isFinite(t) && i < 3; ++i) {
                const HalfEdge h = Topology::halfEdge(t, i);
                if (t_.isGhost(Topology::triangleOf(t_.twin(h)))) {
                    border.push_back(h);
                    onBorder_[t_.origin(h)] = 1;
                }
            }
        }
        while (!border.empty()) {
            const HalfEdge h = border.back();
            border.pop_back();
            const std::uint32_t apex = t_.apex(h);
            if (t_.isConstrained(h) || onBorder_[apex] != 0
                || !isSliver(Topology::triangleOf(h))) {
                continue;
            }
            taken_.push_back(Topology::triangleOf(h));
            onBorder_[apex] = 1;
            border.push_back(t_.twin(Topology::next(h)));
            border.push_back(t_.twin(Topology::prev(h)));
        }
    }

    bool isSliver(std::uint32_t triangle) const
    {
        const auto& v = t_.triangles[triangle].v;
        const Vec2 p[3] = {t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]};
        const double longest = std::sqrt(std::max({squaredLength(p[1] - p[0]),
                                                   squaredLength(p[2] - p[1]),
                                                   squaredLength(p[0] - p[2])}));
        return std::max({made_[v[0]], made_[v[1]], made_[v[2]]}) != 0
            && std::fabs(cross(p[1] - p[0], p[2] - p[0])) <= flat_ * longest;
    }

    const Triangulation& t_;
    bool straight_;     ///< all curves are
    double flat_ = 0.0; ///< greatest height of a sliver
    std::vector<std::uint8_t> made_;     ///< by vertex: it is beside its curve by rounding
    std::vector<std::uint8_t> onBorder_; ///< by vertex: of the triangles that are left
    std::vector<std::uint32_t> taken_;
};

} // namespace

std::vector<std::uint32_t> findHullSlivers(const RecoveryResult& recovered,
                                           const CurveNetwork& network, const Pslg& pslg)
{
    return HullSlivers(recovered, network, pslg).run();
}

} // namespace tessera
