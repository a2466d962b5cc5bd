// SPDX-License-Identifier: MIT
#pragma once

#include "arrange/arcs.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// A place where two curves meet (or one meets itself), by parameters.
struct Contact
{
    std::uint32_t curveA;
    std::uint32_t curveB;
    double s; ///< on curve A
    double t; ///< on curve B
};

/// A length over which two curves stay within the tolerance of each other. b0 belongs to a0; b0 >
/// b1 if they run against each other.
struct Stretch
{
    std::uint32_t curveA;
    std::uint32_t curveB;
    double a0;
    double a1;
    double b0;
    double b1;
};

/// Finds where two arcs meet.
///
/// Both are halved until oriented boxes around them are farther apart than the tolerance, or until
/// their tangents cannot be parallel anywhere: then they cross at most once, and Newton's method
/// finds it. Parts that run along each other within the tolerance are not halved further but
/// reported as stretches; touches and overlaps are made of them. Nothing between the chords is
/// missed, since the boxes hold the curves and not only the chords.
class ArcPairFinder
{
public:
    /// near: distance within which curves count as meeting, far above rounding.
    ArcPairFinder(const CurveSet& curves, double near)
        : curves_(curves)
        , near_(near)
    {}

    /// Two arcs of different curves, or of one curve but not next to each other.
    void find(const Arc& a, const Arc& b);

    std::vector<Contact> crossings;
    std::vector<Stretch> stretches;
    /// A place on each pair that was given up after too many halvings, which bounds the work for
    /// curves that wind around each other near the tolerance. What they miss is left to the recovery
    /// of the chords.
    std::vector<Vec2> unresolved;

private:
    void search(const Arc& a, const Arc& b);
    bool apart(const Arc& a, const Arc& b) const;
    bool neverParallel(const Arc& a, const Arc& b) const;
    bool addCrossing(const Arc& a, const Arc& b);
    bool addStretch(const Arc& a, const Arc& b);

    const CurveSet& curves_;
    double near_;
    int budget_ = 0;
};

} // namespace tessera
