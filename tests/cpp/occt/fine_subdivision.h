// SPDX-License-Identifier: MIT
// Where two curves cross, by subdivision alone: slow, and without anything that the mesher or
// OpenCASCADE do to find it.
#pragma once

#include "base/vec2.h"

#include <Geom_Curve.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tessera::test
{

/// Parameter intervals of both curves whose bounds overlap are halved until they are shorter than
/// 1e-11 x size; what remains is clustered. The bounds of an interval are those of five points on
/// it, grown by half their extent, which holds for the smooth curves of the tests.
class FineSubdivision
{
public:
    FineSubdivision(const Handle(Geom_Curve)& a, const Handle(Geom_Curve)& b, double size)
        : a_(a)
        , b_(b)
        , size_(size)
    {}

    /// self: both are one curve, whose neighboring pieces do not cross.
    std::vector<Vec2> run(bool self)
    {
        constexpr std::size_t kPieces = 256;
        const std::vector<Piece> p = cut(a_, kPieces);
        const std::vector<Piece> q = cut(b_, kPieces);
        std::vector<std::pair<Piece, Piece>> pairs;
        for (std::size_t i = 0; i < kPieces; ++i) {
            for (std::size_t j = self ? i + 2 : 0; j < kPieces; ++j) {
                const bool atSeam = self && a_->IsClosed() && j - i == kPieces - 1;
                if (!atSeam && overlap(p[i], q[j])) {
                    pairs.emplace_back(p[i], q[j]);
                }
            }
        }
        while (!pairs.empty() && std::max(extent(pairs[0].first), extent(pairs[0].second))
                   > 1e-11 * size_) {
            pairs = halved(pairs);
        }
        return clusters(pairs);
    }

private:
    struct Piece
    {
        double from;
        double to;
        Vec2 low;
        Vec2 high;
    };

    static double extent(const Piece& p)
    {
        return std::max(p.high.x - p.low.x, p.high.y - p.low.y);
    }
    static bool overlap(const Piece& p, const Piece& q)
    {
        return p.low.x <= q.high.x && q.low.x <= p.high.x && p.low.y <= q.high.y
            && q.low.y <= p.high.y;
    }

    Piece makePiece(const Handle(Geom_Curve)& curve, double from, double to) const
    {
        Piece piece {from, to, {1e300, 1e300}, {-1e300, -1e300}};
        for (int i = 0; i <= 4; ++i) {
            const gp_Pnt p = curve->Value(from + (to - from) * i / 4);
            piece.low = {std::min(piece.low.x, p.X()), std::min(piece.low.y, p.Y())};
            piece.high = {std::max(piece.high.x, p.X()), std::max(piece.high.y, p.Y())};
        }
        // Short pieces are almost straight: their bounds need no more than their sagitta.
        const double length = extent(piece);
        const double grow = std::min(0.5, length / size_) * length + 1e-14 * size_;
        piece.low = piece.low - Vec2 {grow, grow};
        piece.high = piece.high + Vec2 {grow, grow};
        return piece;
    }

    std::vector<Piece> cut(const Handle(Geom_Curve)& curve, std::size_t count) const
    {
        const double first = curve->FirstParameter();
        const double step = (curve->LastParameter() - first) / static_cast<double>(count);
        std::vector<Piece> pieces;
        for (std::size_t i = 0; i < count; ++i) {
            const double from = first + static_cast<double>(i) * step;
            pieces.push_back(makePiece(curve, from, from + step));
        }
        return pieces;
    }

    std::vector<std::pair<Piece, Piece>>
    halved(const std::vector<std::pair<Piece, Piece>>& pairs) const
    {
        std::vector<std::pair<Piece, Piece>> result;
        for (const auto& [p, q] : pairs) {
            const double s = 0.5 * (p.from + p.to);
            const double t = 0.5 * (q.from + q.to);
            for (const Piece& i : {makePiece(a_, p.from, s), makePiece(a_, s, p.to)}) {
                for (const Piece& j : {makePiece(b_, q.from, t), makePiece(b_, t, q.to)}) {
                    if (overlap(i, j)) {
                        result.emplace_back(i, j);
                    }
                }
            }
        }
        return result;
    }

    std::vector<Vec2> clusters(const std::vector<std::pair<Piece, Piece>>& pairs) const
    {
        std::vector<Vec2> result;
        for (const auto& [p, q] : pairs) {
            const Vec2 middle = midpoint(p.low, p.high);
            const bool known = std::any_of(result.begin(), result.end(), [&](Vec2 r) {
                return distance(r, middle) < 2e-9 * size_;
            });
            if (!known) {
                result.push_back(middle);
            }
        }
        return result;
    }

    Handle(Geom_Curve) a_;
    Handle(Geom_Curve) b_;
    double size_;
};

inline std::vector<Vec2> crossingsByFineSubdivision(const Handle(Geom_Curve)& a,
                                                    const Handle(Geom_Curve)& b, double size)
{
    return FineSubdivision(a, b, size).run(false);
}

inline std::vector<Vec2> selfCrossingsByFineSubdivision(const Handle(Geom_Curve)& curve, double size)
{
    return FineSubdivision(curve, curve, size).run(true);
}

} // namespace tessera::test
