// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

namespace tessera
{

/// Looks for the size with which a mesh has a wanted number of triangles.
///
/// The number falls with the square of the size where the size alone decides, and less where
/// boundaries or local sizes ask for more. So: first the size that fills a given area; then by that
/// square law until the wanted number lies between two outcomes; then by interpolation between their
/// logarithms, kept away from the ends. One to four outcomes are usual.
class CountSearch
{
public:
    static constexpr int kMostRuns = 12;

    /// target triangles are wanted in an area of width × height, with no size below leastSize.
    /// Preconditions: target > 0, width and height > 0, leastSize >= 0.
    CountSearch(double target, double width, double height, double leastSize = 0.0);

    /// The size to try.
    double next() const;

    /// Takes the number of triangles that next() made. False if no other size is worth a try: the
    /// number is within two percent, or nothing can bring it nearer.
    bool take(double triangles);

    /// True if triangles is within five percent.
    bool isReached(double triangles) const;

    /// True if no outcome before was as near to the target as the last one taken.
    bool isBest() const { return lastIsBest_; }

private:
    /// Logarithms of a size and of how many times too many triangles it made.
    struct Outcome
    {
        double size;
        double excess;
    };

    /// The logarithm of a size, brought into the bounds.
    double bounded(double size) const { return std::min(std::max(size, smallest_), largest_); }

    double target_;
    double smallest_; ///< logarithm
    double largest_;  ///< logarithm
    double next_;     ///< logarithm
    double least_;   ///< |excess| so far
    bool lastIsBest_ = false;
    std::optional<Outcome> tooMany_;
    std::optional<Outcome> tooFew_;
};

} // namespace tessera
