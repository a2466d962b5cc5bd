// SPDX-License-Identifier: MIT
#include "region/faces.h"

#include "region/region.h"

#include <utility>

namespace tessera
{

namespace
{

class FaceFlood
{
public:
    FaceFlood(const RecoveryResult& recovered, const SubsegmentGraph& graph,
              const std::vector<std::uint32_t>* outsideHull, Execution& execution)
        : t_(recovered.triangulation)
        , subsegmentCount_(recovered.constraints.subsegments.size())
        , graph_(graph)
        , outsideHull_(outsideHull)
        , execution_(execution)
    {}

    FaceGraph run()
    {
        faces_.faceOfTriangle.assign(t_.triangles.size(), FaceGraph::kNoFace);
        for (const std::uint32_t seed : outerSeeds(t_)) {
            faces_.faceOfTriangle[seed] = 0;
            stack_.push_back(seed);
        }
        flood();
        if (outsideHull_ != nullptr) {
            for (const std::uint32_t t : *outsideHull_) {
                faces_.faceOfTriangle[t] = 0;
            }
        }
        faces_.faceCount = 1;
        for (std::uint32_t t = 0; t < t_.triangles.size(); ++t) {
            if (faces_.faceOfTriangle[t] == FaceGraph::kNoFace && !t_.isDead(t)) {
                const auto face = static_cast<std::uint32_t>(faces_.faceCount++);
                faces_.faceOfTriangle[t] = face;
                stack_.push_back(t);
                flood();
            }
        }
        link();
        return std::move(faces_);
    }

private:
    bool separates(HalfEdge h) const
    {
        const bool ghost = t_.isGhost(Topology::triangleOf(h));
        const bool ghostBeyond = t_.isGhost(Topology::triangleOf(t_.twin(h)));
        return t_.isConstrained(h) || (outsideHull_ != nullptr && ghost != ghostBeyond);
    }

    /// From the triangles on the stack, which have their face, to all of the same face.
    void flood()
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
                if (faces_.faceOfTriangle[next] == FaceGraph::kNoFace && !separates(h)) {
                    faces_.faceOfTriangle[next] = faces_.faceOfTriangle[t];
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
        if (outsideHull_ != nullptr) {
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
    const std::vector<std::uint32_t>* outsideHull_;
    Execution& execution_;
    FaceGraph faces_;
    std::vector<std::uint32_t> stack_;
    std::uint64_t visited_ = 0;
};

} // namespace

FaceGraph buildFaces(const RecoveryResult& recovered, const SubsegmentGraph& graph,
                     Execution& execution)
{
    return FaceFlood(recovered, graph, nullptr, execution).run();
}

FaceGraph buildHullFaces(const RecoveryResult& recovered, const SubsegmentGraph& graph,
                         const std::vector<std::uint32_t>& outside, Execution& execution)
{
    return FaceFlood(recovered, graph, &outside, execution).run();
}

} // namespace tessera
