// SPDX-License-Identifier: MIT
#include "sample/separate.h"

#include "arrange/box_tree.h"
#include "base/box2.h"
#include "curve/curve_tools.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera
{

namespace
{

constexpr int kMostRounds = 16;
/// Halving stops when it has made this many pieces of each piece there was, and some: curves that
/// run on each other without sharing their geometry would never come apart.
constexpr std::size_t kMostParts = 16;
constexpr std::size_t kMostPartsBeside = 10000;
/// Part of the greatest coordinate below which a point counts as on a curve.
constexpr double kOnCurve = 1e-12;

class PieceSeparator
{
public:
    PieceSeparator(std::vector<Vec2>& points, std::vector<CurvePiece>& pieces,
                   Execution& execution)
        : points_(points)
        , pieces_(pieces)
        , execution_(execution)
        , isNew_(pieces.size(), 1)
        , isHalf_(pieces.size(), 0)
    {
        for (const Vec2 p : points) {
            scale_ = std::max({scale_, std::abs(p.x), std::abs(p.y)});
        }
        std::vector<std::uint8_t> isEnd(points.size(), 0);
        for (const CurvePiece& piece : pieces) {
            isEnd[piece.a.index()] = isEnd[piece.b.index()] = 1;
        }
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (isEnd[p] == 0) {
                lonePoints_.push_back(points[p]);
            }
        }
        sagitta_.reserve(pieces.size());
        for (const CurvePiece& piece : pieces) {
            sagitta_.push_back(sagittaOf(piece));
        }
    }

    Separation run()
    {
        Separation result;
        result.done = separate();
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (isHalf_[i] != 0) {
                result.halves.push_back(pieces_[i]);
            }
        }
        return result;
    }

private:
    bool separate()
    {
        const std::size_t most = kMostParts * pieces_.size() + kMostPartsBeside;
        for (int round = 0; round < kMostRounds && pieces_.size() <= most; ++round) {
            if (!findConflicts()) {
                return true;
            }
            halveMarked();
        }
        return false;
    }

    static double sagittaOf(const CurvePiece& piece)
    {
        return piece.geometry == nullptr
            ? 0.0
            : sagittaBound(*piece.geometry, std::min(piece.ta, piece.tb),
                           std::max(piece.ta, piece.tb));
    }

    Vec2 start(std::size_t i) const { return points_[pieces_[i].a.index()]; }
    Vec2 end(std::size_t i) const { return points_[pieces_[i].b.index()]; }
    bool canBeHalved(std::size_t i) const { return sagitta_[i] > kOnCurve * scale_; }

    Box2 chordBox(std::size_t i) const
    {
        Box2 box;
        box.add(start(i));
        box.add(end(i));
        return box;
    }

    /// Marks the pieces to halve. Only pieces made in the last round can have new conflicts.
    bool findConflicts()
    {
        std::vector<std::uint32_t> suspects;
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            if (isNew_[i] != 0 && canBeHalved(i)) {
                suspects.push_back(i);
            }
        }
        marked_.assign(pieces_.size(), 0);
        if (suspects.empty()) {
            return false;
        }
        std::vector<Box2> boxes;
        boxes.reserve(pieces_.size());
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            boxes.push_back(chordBox(i).grown(sagitta_[i]));
        }
        for (const Vec2 p : lonePoints_) {
            boxes.push_back({p, p});
        }
        const BoxTree tree(boxes);
        bool found = false;
        for (std::size_t k = 0; k < suspects.size(); ++k) {
            if (k % 1024 == 0) {
                execution_.checkpoint();
            }
            const std::uint32_t i = suspects[k];
            tree.forEachOverlap(boxes[i], [this, i, &found](std::uint32_t j) {
                if (j >= pieces_.size()) {
                    if (isBetween(i, lonePoints_[j - pieces_.size()])) {
                        found = mark(i, i) || found;
                    }
                }
                else if (i != j && (cross(i, j) || between(i, j) || between(j, i))) {
                    found = mark(i, j) || found;
                }
            });
        }
        return found;
    }

    /// The chords have a point in common that is no common end, or run on each other from one.
    bool cross(std::size_t i, std::size_t j) const
    {
        const Vec2 a = start(i);
        const Vec2 b = end(i);
        const Vec2 c = start(j);
        const Vec2 d = end(j);
        if ((a == c && b == d) || (a == d && b == c)) {
            return false; // one on the other: the same curve twice
        }
        if (a == c || a == d || b == c || b == d) {
            const Vec2 shared = a == c || a == d ? a : b;
            const Vec2 p = shared == a ? b : a;
            const Vec2 q = shared == c ? d : c;
            return orient2d(shared, p, q) == 0 && dot(p - shared, q - shared) > 0.0;
        }
        return orient2d(a, b, c) * orient2d(a, b, d) <= 0
            && orient2d(c, d, a) * orient2d(c, d, b) <= 0 && chordBox(i).overlaps(chordBox(j));
    }

    /// An end of j lies between i and its curve: on one side of the chord, on the other of the
    /// curve.
    bool between(std::size_t i, std::size_t j) const
    {
        if (!canBeHalved(i)) {
            return false;
        }
        return isBetween(i, start(j)) || isBetween(i, end(j));
    }

    bool isBetween(std::size_t i, Vec2 p) const
    {
        const Vec2 a = start(i);
        const Vec2 b = end(i);
        const Vec2 chord = b - a;
        const double along = dot(p - a, chord);
        if (p == a || p == b || along <= 0.0 || along >= squaredLength(chord)) {
            return false;
        }
        const double side = tessera::cross(chord, p - a);
        if (std::abs(side) > sagitta_[i] * length(chord)) {
            return false;
        }
        const CurvePiece& piece = pieces_[i];
        const double t = nearestParameter(piece, along / squaredLength(chord), p);
        const Vec2 offset = p - piece.geometry->point(t);
        if (length(offset) <= kOnCurve * scale_) {
            return false;
        }
        const Vec2 tangent =
            (piece.ta < piece.tb ? 1.0 : -1.0) * piece.geometry->derivative(t);
        return (side > 0.0) != (tessera::cross(tangent, offset) > 0.0);
    }

    static double nearestParameter(const CurvePiece& piece, double share, Vec2 p)
    {
        const double low = std::min(piece.ta, piece.tb);
        const double high = std::max(piece.ta, piece.tb);
        double t = piece.ta + share * (piece.tb - piece.ta);
        for (int i = 0; i < 20; ++i) {
            const Vec2 offset = piece.geometry->point(t) - p;
            const Vec2 d = piece.geometry->derivative(t);
            const double slope = squaredLength(d);
            if (!(slope > 0.0)) {
                break;
            }
            const double next = std::clamp(t - dot(offset, d) / slope, low, high);
            const double step = std::abs(next - t);
            t = next;
            if (step <= 1e-14 * (high - low)) {
                break;
            }
        }
        return t;
    }

    /// The flatter of the two stays as it is if the other one alone can be in the way.
    bool mark(std::size_t i, std::size_t j)
    {
        const double limit = 0.25 * std::max(sagitta_[i], sagitta_[j]);
        bool any = false;
        for (const std::size_t k : {i, j}) {
            if (sagitta_[k] >= limit && canBeHalved(k)) {
                marked_[k] = 1;
                any = true;
            }
        }
        return any;
    }

    void halveMarked()
    {
        std::vector<CurvePiece> pieces;
        std::vector<double> sagittas;
        std::vector<std::uint8_t> isNew;
        std::vector<std::uint8_t> isHalf;
        const auto add = [&](const CurvePiece& piece, double sagitta, std::uint8_t created,
                             std::uint8_t half) {
            pieces.push_back(piece);
            sagittas.push_back(sagitta);
            isNew.push_back(created);
            isHalf.push_back(half);
        };
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const CurvePiece& piece = pieces_[i];
            if (marked_[i] == 0) {
                add(piece, sagitta_[i], 0, isHalf_[i]);
                continue;
            }
            const double middle = 0.5 * (piece.ta + piece.tb);
            points_.push_back(piece.geometry->point(middle));
            CurvePiece left = piece;
            CurvePiece right = piece;
            left.b = right.a = PointId(points_.size() - 1);
            left.tb = right.ta = middle;
            add(left, sagittaOf(left), 1, 1);
            add(right, sagittaOf(right), 1, 1);
        }
        pieces_ = std::move(pieces);
        sagitta_ = std::move(sagittas);
        isNew_ = std::move(isNew);
        isHalf_ = std::move(isHalf);
    }

    std::vector<Vec2>& points_;
    std::vector<CurvePiece>& pieces_;
    Execution& execution_;
    std::vector<Vec2> lonePoints_; ///< at no piece's end
    std::vector<std::uint8_t> isNew_;
    std::vector<std::uint8_t> isHalf_; ///< made here
    std::vector<std::uint8_t> marked_;
    std::vector<double> sagitta_;
    double scale_ = 0.0;
};

} // namespace

Separation separatePieces(std::vector<Vec2>& points, std::vector<CurvePiece>& pieces,
                          Execution& execution)
{
    return PieceSeparator(points, pieces, execution).run();
}

} // namespace tessera
