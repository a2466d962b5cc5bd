// SPDX-License-Identifier: MIT
//
// Dijkstra's algorithm over the graph whose nodes are the ends of sources. Events are taken by
// rising value: a node's value spreads along the sources that end there; a source's own size, when
// its turn comes, is spread from its ends unless smaller ones have already taken care of it.
#include "sizing/graded_size.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace tessera
{

namespace
{

struct Event
{
    double value;
    std::uint32_t index; ///< of a node, or of a source
    bool isSource;
    bool operator>(const Event& other) const
    {
        return std::tie(value, index, isSource)
            > std::tie(other.value, other.index, other.isSource);
    }
};

class DominationFinder
{
public:
    DominationFinder(std::span<const SizeSource> sources, double growth, double tolerance)
        : sources_(sources)
        , growth_(growth)
        , tolerance_(tolerance)
        , kept_(sources.size(), 0)
    {
        numberEnds();
        linkEnds();
    }

    std::vector<SizeSource> run()
    {
        spread();
        std::vector<SizeSource> result;
        for (std::uint32_t i = 0; i < sources_.size(); ++i) {
            if (kept_[i] != 0) {
                result.push_back(sources_[i]);
            }
        }
        return result;
    }

private:
    Vec2 positionOf(std::uint32_t end) const
    {
        return end % 2 == 0 ? sources_[end / 2].a : sources_[end / 2].b;
    }

    /// Equal positions get one number.
    void numberEnds()
    {
        std::vector<std::uint32_t> order(2 * sources_.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::sort(order.begin(), order.end(), [this](std::uint32_t p, std::uint32_t q) {
            const Vec2 a = positionOf(p);
            const Vec2 b = positionOf(q);
            return a.x != b.x ? a.x < b.x : a.y < b.y;
        });
        nodeOf_.resize(order.size());
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (i > 0 && positionOf(order[i]) != positionOf(order[i - 1])) {
                ++count;
            }
            nodeOf_[order[i]] = count;
        }
        nodes_ = order.empty() ? 0 : count + 1;
    }

    void linkEnds()
    {
        start_.assign(nodes_ + 1, 0);
        for (const std::uint32_t node : nodeOf_) {
            ++start_[node + 1];
        }
        for (std::size_t v = 0; v < nodes_; ++v) {
            start_[v + 1] += start_[v];
        }
        endsAt_.resize(nodeOf_.size());
        std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
        for (std::uint32_t end = 0; end < nodeOf_.size(); ++end) {
            endsAt_[fill[nodeOf_[end]]++] = end;
        }
    }

    void spread()
    {
        value_.assign(nodes_, std::numeric_limits<double>::infinity());
        for (std::uint32_t i = 0; i < sources_.size(); ++i) {
            queue_.push({sources_[i].size, i, true});
        }
        while (!queue_.empty()) {
            const Event event = queue_.top();
            queue_.pop();
            if (event.isSource) {
                lookAt(event.index);
            }
            else if (event.value <= value_[event.index]) {
                spreadFrom(event);
            }
        }
    }

    void lookAt(std::uint32_t i)
    {
        const SizeSource& source = sources_[i];
        const double across = growth_ * distance(source.a, source.b);
        const double least = std::min(value_[nodeOf_[2 * i]], value_[nodeOf_[2 * i + 1]]);
        if (!source.isPlain() || least + across > tolerance_ * source.size) {
            kept_[i] = 1;
            lower(nodeOf_[2 * i], source.size);
            lower(nodeOf_[2 * i + 1], source.size);
        }
    }

    void lower(std::uint32_t node, double value)
    {
        if (value < value_[node]) {
            value_[node] = value;
            queue_.push({value, node, false});
        }
    }

    void spreadFrom(const Event& event)
    {
        for (std::uint32_t k = start_[event.index]; k < start_[event.index + 1]; ++k) {
            const SizeSource& source = sources_[endsAt_[k] / 2];
            lower(nodeOf_[endsAt_[k] ^ 1U],
                  event.value + growth_ * distance(source.a, source.b));
        }
    }

    std::span<const SizeSource> sources_;
    double growth_;
    double tolerance_;
    std::vector<std::uint8_t> kept_;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
    std::size_t nodes_ = 0;
    std::vector<std::uint32_t> nodeOf_; ///< by end: 2 x source, plus 1 for b
    std::vector<std::uint32_t> start_;
    std::vector<std::uint32_t> endsAt_; ///< by node, from start_
    std::vector<double> value_;         ///< by node
};

} // namespace

std::vector<SizeSource> withoutDominated(std::span<const SizeSource> sources, double growth,
                                         double tolerance)
{
    return DominationFinder(sources, growth, tolerance).run();
}

} // namespace tessera
