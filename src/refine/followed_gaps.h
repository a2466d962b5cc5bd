// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace tessera
{

/// How short pieces of constrained edges may become beside the narrow gaps that are followed: by side
/// of a recovered subsegment and by the distance from its start. Away from such gaps the lengths grow
/// by kGrowth per distance.
class FollowedGaps
{
public:
    static constexpr double kGrowth = 0.1;

    /// Between two places along a side, from <= to. Call finish() after the last one.
    void add(std::uint32_t side, double from, double to, double piece)
    {
        spans_.push_back({side, from, to, piece});
    }

    /// Complexity: O(n log n) for n spans.
    void finish();

    bool empty() const { return stops_.empty(); }
    void clear();

    /// The least length of pieces at a place along a side; infinite if none of its gaps is followed.
    /// Complexity: O(log n).
    double at(std::uint32_t side, double place) const;

private:
    struct Span
    {
        std::uint32_t side;
        double from;
        double to;
        double piece;
    };
    /// Where spans begin or end.
    struct Stop
    {
        double place;
        double piece;  ///< here, also by spans elsewhere
        double onward; ///< of the spans that reach from here to the next stop; infinite if none
    };

    void addStops(const Span* first, const Span* last);

    std::vector<Span> spans_; ///< until finish()
    std::vector<Stop> stops_; ///< by side, in order
    std::vector<std::uint32_t> firstStop_; ///< by side, and one more
};

} // namespace tessera
