// SPDX-License-Identifier: MIT
#include "region/marked_points.h"

#include "base/number_text.h"
#include "delaunay/delaunay.h"

#include <algorithm>

namespace tessera
{

namespace
{

class FaceMarker
{
public:
    FaceMarker(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
               const FaceGraph& faces, Execution& execution)
        : t_(recovered.triangulation)
        , map_(recovered.constraints)
        , network_(network)
        , pslg_(pslg)
        , faces_(faces)
        , execution_(execution)
        , reachedBy_(faces.faceCount, 0)
    {
        while (hint_ < 4 * t_.triangles.size() && t_.isDead(Topology::triangleOf(hint_))) {
            hint_ += 4;
        }
    }

    MarkedFaces run(bool withHoles)
    {
        for (std::size_t i = 0; withHoles && i < network_.holes.size(); ++i) {
            const HolePoint& hole = network_.holes[i];
            const std::uint32_t first = faceAt(hole.position, "A hole point");
            for (const std::uint32_t face : facesAround(first, hole.operand)) {
                marked_.removed.emplace_back(face, hole.operand.value);
                if (face == first) {
                    marked_.holes.emplace_back(face, hole.operand.value);
                }
            }
        }
        std::sort(marked_.holes.begin(), marked_.holes.end());
        std::sort(marked_.removed.begin(), marked_.removed.end());
        marked_.removed.erase(std::unique(marked_.removed.begin(), marked_.removed.end()),
                              marked_.removed.end());
        if (!marked_.removed.empty()) {
            marked_.hasRemoval.assign(faces_.faceCount, 0);
            for (const auto& [face, operand] : marked_.removed) {
                marked_.hasRemoval[face] = 1;
            }
        }
        for (std::uint32_t i = 0; i < network_.regions.size(); ++i) {
            paint(i);
        }
        return std::move(marked_);
    }

private:
    /// The face that holds p; 0, the outer one, if p is outside or on a curve.
    std::uint32_t faceAt(Vec2 p, const char* who)
    {
        execution_.checkpoint();
        if (hint_ >= 4 * t_.triangles.size()) {
            return 0;
        }
        const Location where = locate(t_, p, hint_);
        bool onCurve = false;
        if (where.kind == Location::Kind::Edge) {
            onCurve = t_.isConstrained(where.edge);
        }
        else if (where.kind == Location::Kind::Vertex) {
            t_.forEachAround(t_.origin(where.edge), [this, &onCurve](HalfEdge h) {
                onCurve = onCurve || t_.isConstrained(h);
            });
        }
        hint_ = where.edge & ~3U;
        if (onCurve) {
            marked_.messages.push_back(who + (" at " + placeText(p))
                                       + " lies on a curve and has no effect; move it inside.");
            return 0;
        }
        const std::uint32_t here = faces_.faceOfTriangle[Topology::triangleOf(where.edge)];
        // On a hull edge that is no curve, or at a hull vertex, both sides are one face unless the
        // hull itself separates: then the inner side counts.
        const std::uint32_t there =
            where.kind == Location::Kind::Edge
            ? faces_.faceOfTriangle[Topology::triangleOf(t_.twin(where.edge))]
            : here;
        return std::max(here, there);
    }

    /// All faces around the given one up to the operand's curves; none if they reach the outside.
    std::vector<std::uint32_t> facesAround(std::uint32_t first, OperandId operand)
    {
        if (first == 0) {
            return {};
        }
        ++stamp_;
        std::vector<std::uint32_t> found {first};
        reachedBy_[first] = stamp_;
        for (std::size_t i = 0; i < found.size(); ++i) {
            for (const std::uint32_t link : faces_.linksOf(found[i])) {
                const std::uint32_t beyond = faces_.across(link, found[i]);
                if (reachedBy_[beyond] == stamp_ || isOf(operand, link)) {
                    continue;
                }
                if (beyond == 0) {
                    return {};
                }
                reachedBy_[beyond] = stamp_;
                found.push_back(beyond);
            }
        }
        return found;
    }

    bool isOf(OperandId operand, std::uint32_t link) const
    {
        const std::uint32_t s = faces_.links[link].subsegment;
        if (s == FaceLink::kNoSubsegment) {
            return true; // the hull under FillRule::Hull
        }
        for (const ConstraintUse& use : map_.usesOf(map_.subsegments[s])) {
            const CurveId curve = pslg_.segments[use.constraint.index()].curve;
            if (network_.curves[curve.index()].operand == operand) {
                return true;
            }
        }
        return false;
    }

    void paint(std::uint32_t index)
    {
        const RegionPoint& point = network_.regions[index];
        const std::uint32_t first = faceAt(point.position, "A region point");
        if (marked_.regionPoint.empty()) {
            marked_.regionPoint.assign(faces_.faceCount, MarkedFaces::kNoPoint);
        }
        bool taken = false;
        for (const std::uint32_t face : facesAround(first, point.operand)) {
            taken = taken || marked_.regionPoint[face] != MarkedFaces::kNoPoint;
            if (marked_.regionPoint[face] == MarkedFaces::kNoPoint) {
                marked_.regionPoint[face] = index;
            }
        }
        if (taken) {
            marked_.messages.push_back("The region point at " + placeText(point.position)
                                       + " shares a face with an earlier one, which counts.");
        }
    }

    const Triangulation& t_;
    const ConstraintMap& map_;
    const CurveNetwork& network_;
    const Pslg& pslg_;
    const FaceGraph& faces_;
    Execution& execution_;
    MarkedFaces marked_;
    HalfEdge hint_ = 0;
    std::vector<std::uint32_t> reachedBy_;
    std::uint32_t stamp_ = 0;
};

} // namespace

MarkedFaces markFaces(const RecoveryResult& recovered, const CurveNetwork& network,
                      const Pslg& pslg, const FaceGraph& faces, bool withHoles,
                      Execution& execution)
{
    return FaceMarker(recovered, network, pslg, faces, execution).run(withHoles);
}

} // namespace tessera
