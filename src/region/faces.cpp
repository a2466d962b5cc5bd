// SPDX-License-Identifier: MIT
#include "region/faces.h"

#include "region/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera
{

namespace
{

/// Of the greatest coordinate: some units in the last place.
constexpr double kFlat = 16.0 * std::numeric_limits<double>::epsilon();

class FaceFlood
{
public:
    FaceFlood(const RecoveryResult& recovered, const SubsegmentGraph& graph, bool hullSeparates,
              Execution& execution)
        : t_(recovered.triangulation)
        , subsegmentCount_(recovered.constraints.subsegments.size())
        , graph_(graph)
        , hullSeparates_(hullSeparates)
        , execution_(execution)
    {}

    FaceGraph run()
    {
        faces_.faceOfTriangle.assign(t_.triangles.size(), FaceGraph::kNoFace);
        for (std::uint32_t v = 1; hullSeparates_ && v < t_.points.size(); ++v) {
            flat_ = std::max({flat_, kFlat * std::fabs(t_.points[v].x),
                              kFlat * std::fabs(t_.points[v].y)});
        }
        for (const std::uint32_t seed : outerSeeds(t_)) {
            faces_.faceOfTriangle[seed] = 0;
            stack_.push_back(seed);
        }
        flood(0);
        faces_.faceCount = 1;
        for (std::uint32_t t = 0; t < t_.triangles.size(); ++t) {
            if (faces_.faceOfTriangle[t] == FaceGraph::kNoFace && !t_.isDead(t)) {
                const auto face = static_cast<std::uint32_t>(faces_.faceCount++);
                faces_.faceOfTriangle[t] = face;
                stack_.push_back(t);
                flood(face);
            }
        }
        link();
        return std::move(faces_);
    }

private:
    /// h is an edge of a triangle of the face.
    bool separates(HalfEdge h, std::uint32_t face) const
    {
        const std::uint32_t beyond = Topology::triangleOf(t_.twin(h));
        if (t_.isConstrained(h) || !hullSeparates_) {
            return t_.isConstrained(h);
        }
        if (face == 0) {
            return !t_.isGhost(beyond) && !isFlat(beyond);
        }
        return t_.isGhost(beyond);
    }

    /// Flatter than the rounding of constructed points can make what lies on one line.
    bool isFlat(std::uint32_t triangle) const
    {
        const auto& v = t_.triangles[triangle].v;
        const Vec2 p[3] = {t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]};
        const double longest = std::sqrt(std::max({squaredLength(p[1] - p[0]),
                                                   squaredLength(p[2] - p[1]),
                                                   squaredLength(p[0] - p[2])}));
        return std::fabs(cross(p[1] - p[0], p[2] - p[0])) <= flat_ * longest;
    }

    void flood(std::uint32_t face)
    {
        while (!stack_.empty()) {
            const std::uint32_t t = stack_.back();
            stack_.pop_back();
            if ((++visited_ & 0xffffU) == 0) {
                execution_.checkpoint();
            }
            for (std::uint32_t i = 0; i < 3; ++i) {
                const HalfEdge h = Topology::halfEdge(t, i);
                const std::uint32_t next = Topology::triangleOf(t_.twin(h));
                if (faces_.faceOfTriangle[next] == FaceGraph::kNoFace && !separates(h, face)) {
                    faces_.faceOfTriangle[next] = face;
                    stack_.push_back(next);
                }
            }
        }
    }

    std::uint32_t faceLeftOf(HalfEdge h) const
    {
        return faces_.faceOfTriangle[Topology::triangleOf(h)];
    }

    void link()
    {
        for (std::uint32_t s = 0; s < subsegmentCount_; ++s) {
            const HalfEdge h = graph_.halfEdge(s);
            if (h == Topology::kDead) {
                faces_.links.push_back({0, 0, s});
            }
            else {
                faces_.links.push_back({faceLeftOf(h), faceLeftOf(t_.twin(h)), s});
            }
        }
        if (hullSeparates_) {
            linkHull();
        }
        faces_.start.assign(faces_.faceCount + 1, 0);
        const auto forEachEnd = [this](auto f) {
            for (std::uint32_t i = 0; i < faces_.links.size(); ++i) {
                if (faces_.links[i].left != faces_.links[i].right) {
                    f(faces_.links[i].left, i);
                    f(faces_.links[i].right, i);
                }
            }
        };
        forEachEnd([this](std::uint32_t face, std::uint32_t) { ++faces_.start[face + 1]; });
        for (std::size_t f = 0; f < faces_.faceCount; ++f) {
            faces_.start[f + 1] += faces_.start[f];
        }
        faces_.linksAt.resize(faces_.start.back());
        std::vector<std::uint32_t> fill(faces_.start.begin(), faces_.start.end() - 1);
        forEachEnd([this, &fill](std::uint32_t face, std::uint32_t i) {
            faces_.linksAt[fill[face]++] = i;
        });
    }

    void linkHull()
    {
        for (std::uint32_t t = 0; t < t_.triangles.size(); ++t) {
            if (t_.isDead(t) || faces_.faceOfTriangle[t] != 0) {
                continue;
            }
            for (std::uint32_t i = 0; i < 3; ++i) {
                const HalfEdge h = Topology::halfEdge(t, i);
                if (!t_.isConstrained(h) && faceLeftOf(t_.twin(h)) != 0) {
                    faces_.links.push_back(
                        {faceLeftOf(h), faceLeftOf(t_.twin(h)), FaceLink::kNoSubsegment});
                }
            }
        }
    }

    const Triangulation& t_;
    std::size_t subsegmentCount_;
    const SubsegmentGraph& graph_;
    bool hullSeparates_;
    double flat_ = 0.0; ///< greatest height of a flat triangle
    Execution& execution_;
    FaceGraph faces_;
    std::vector<std::uint32_t> stack_;
    std::uint64_t visited_ = 0;
};

} // namespace

FaceGraph buildFaces(const RecoveryResult& recovered, const SubsegmentGraph& graph,
                     bool hullSeparates, Execution& execution)
{
    return FaceFlood(recovered, graph, hullSeparates, execution).run();
}

} // namespace tessera
