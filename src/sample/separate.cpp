// SPDX-License-Identifier: MIT
#include "sample/separate.h"

#include "arrange/box_tree.h"
#include "base/box2.h"
#include "curve/curve_tools.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tessera
{

namespace
{

constexpr int kMostRounds = 16;
/// Halving for the topology stops when it has made so many pieces of each piece there was, and some:
/// curves that run on each other without sharing their geometry would never come apart. Few pieces
/// may become more each.
constexpr std::size_t kMostParts = 16;
constexpr std::size_t kMostPartsOfFew = 64;
constexpr std::size_t kFew = 2000;
constexpr std::size_t kMostPartsBeside = 20000;
/// Part of the greatest coordinate below which a point counts as on a curve.
constexpr double kOnCurve = 1e-12;
/// A gap that closes at a common end of two curves is followed up to this part of the shorter one.
constexpr double kTip = 0.02;

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b)
{
    const Vec2 chord = b - a;
    const double square = squaredLength(chord);
    const double share = square > 0.0 ? std::clamp(dot(p - a, chord) / square, 0.0, 1.0) : 0.0;
    return distance(p, a + share * chord);
}

class PieceSeparator
{
public:
    PieceSeparator(std::vector<Vec2>& points, std::vector<CurvePiece>& pieces,
                   const SeparateOptions& options, Execution& execution)
        : points_(points)
        , pieces_(pieces)
        , options_(options)
        , execution_(execution)
        , wholePieces_(pieces)
        , wholePoints_(points.size())
        , followsGaps_(pieces.size(), options.gapShare > 0.0 ? 1 : 0)
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
        findStrands();
    }

    Separation run()
    {
        Separation result;
        result.done = separate();
        if (options_.gapShare > 0.0 && (!result.done || !coarseGaps_.empty())) {
            // Once more, without the pieces that would need too many parts, or without any.
            for (std::size_t i = 0; i < followsGaps_.size() && !result.done; ++i) {
                followsGaps_[i] = 0;
            }
            result.coarseGaps = std::move(coarseGaps_);
            result.done = separate();
        }
        result.unseparated = lastConflict_;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (isHalf_[i] != 0) {
                result.halves.push_back(pieces_[i]);
            }
        }
        return result;
    }

private:
    /// A curve between its first and its last piece.
    struct Strand
    {
        PointId start;
        PointId end;
        double length = 0.0;
    };

    void findStrands()
    {
        for (const CurvePiece& piece : pieces_) {
            const std::size_t c = piece.curve.index();
            if (c >= strands_.size()) {
                strands_.resize(c + 1);
            }
            Strand& strand = strands_[c];
            if (!strand.start.valid()) {
                strand.start = piece.a;
            }
            strand.end = piece.b;
            strand.length += distance(points_[piece.a.index()], points_[piece.b.index()]);
        }
    }

    bool separate()
    {
        pieces_ = wholePieces_;
        points_.resize(wholePoints_);
        isNew_.assign(pieces_.size(), 1);
        isHalf_.assign(pieces_.size(), 0);
        whole_.resize(pieces_.size());
        std::iota(whole_.begin(), whole_.end(), 0U);
        parts_.assign(pieces_.size(), 1);
        coarseGaps_.clear();
        halvesForGaps_ = 0;
        sagitta_.clear();
        sagitta_.reserve(pieces_.size());
        for (const CurvePiece& piece : pieces_) {
            sagitta_.push_back(sagittaOf(piece));
        }
        const std::size_t most = kMostParts * pieces_.size()
            + (kMostPartsOfFew - kMostParts) * std::min(pieces_.size(), kFew) + kMostPartsBeside;
        for (int round = 0; round < kMostRounds && pieces_.size() <= most + halvesForGaps_;
             ++round) {
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
            double share = 0.0;
            const Box2 reach = boxes[i].grown(followsGaps_[whole_[i]] != 0
                                                  ? sagitta_[i] / options_.gapShare
                                                  : 0.0);
            tree.forEachOverlap(reach, [&](std::uint32_t j) {
                if (j >= pieces_.size()) {
                    if (isBetween(i, lonePoints_[j - pieces_.size()])) {
                        found = mark(i, i) || found;
                    }
                }
                else if (i != j && (cross(i, j) || between(i, j) || between(j, i))) {
                    found = mark(i, j) || found;
                }
                else if (i != j && followsGaps_[whole_[i]] != 0 && !hangTogether(i, j)) {
                    share = std::max(share, sagitta_[i] / gapBetween(i, j));
                }
            });
            if (share > options_.gapShare && marked_[i] == 0) {
                found = halveForGap(i, share) || found;
            }
        }
        return found;
    }

    /// False where that would make too many pieces: then the whole piece is not to follow gaps.
    bool halveForGap(std::uint32_t i, double share)
    {
        const std::uint32_t whole = whole_[i];
        if (halvesForGaps_ < options_.mostHalvesForGaps) {
            ++halvesForGaps_;
            return mark(i, i);
        }
        followsGaps_[whole] = 0;
        const double parts = parts_[whole];
        coarseGaps_.push_back({midpoint(start(i), end(i)), share * parts * parts});
        return false;
    }

    /// The distance of two chords that do not cross.
    double gapBetween(std::size_t i, std::size_t j) const
    {
        return std::min({distanceToSegment(start(i), start(j), end(j)),
                         distanceToSegment(end(i), start(j), end(j)),
                         distanceToSegment(start(j), start(i), end(i)),
                         distanceToSegment(end(j), start(i), end(i))});
    }

    /// Neighbors on a curve or around a common end of two, or pieces of a curve that is there twice.
    bool hangTogether(std::size_t i, std::size_t j) const
    {
        const CurvePiece& p = pieces_[i];
        const CurvePiece& q = pieces_[j];
        const Vec2 a = start(i);
        const Vec2 b = end(i);
        if (a == start(j) || a == end(j) || b == start(j) || b == end(j)) {
            return true;
        }
        if (p.geometry == q.geometry && p.geometry != nullptr) {
            const double between = std::max(std::min(p.ta, p.tb), std::min(q.ta, q.tb))
                - std::min(std::max(p.ta, p.tb), std::max(q.ta, q.tb));
            if (between <= 2.0 * std::max(std::abs(p.tb - p.ta), std::abs(q.tb - q.ta))) {
                return true;
            }
        }
        const Strand& s = strands_[p.curve.index()];
        const Strand& t = strands_[q.curve.index()];
        const double tip =
            std::max(2.0 * distance(a, b), kTip * std::min(s.length, t.length));
        for (const PointId common : {s.start, s.end}) {
            const Vec2 v = points_[common.index()];
            if ((common == t.start || common == t.end)
                && std::min(distance(a, v), distance(b, v)) <= tip) {
                return true;
            }
        }
        return false;
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
        std::vector<std::uint32_t> whole;
        const auto add = [&](const CurvePiece& piece, double sagitta, std::size_t from,
                             bool created) {
            pieces.push_back(piece);
            sagittas.push_back(sagitta);
            isNew.push_back(created ? 1 : 0);
            isHalf.push_back(created ? 1 : isHalf_[from]);
            whole.push_back(whole_[from]);
        };
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const CurvePiece& piece = pieces_[i];
            if (marked_[i] == 0) {
                add(piece, sagitta_[i], i, false);
                continue;
            }
            ++parts_[whole_[i]];
            lastConflict_ = start(i);
            const double middle = 0.5 * (piece.ta + piece.tb);
            points_.push_back(piece.geometry->point(middle));
            CurvePiece left = piece;
            CurvePiece right = piece;
            left.b = right.a = PointId(points_.size() - 1);
            left.tb = right.ta = middle;
            add(left, sagittaOf(left), i, true);
            add(right, sagittaOf(right), i, true);
        }
        pieces_ = std::move(pieces);
        sagitta_ = std::move(sagittas);
        isNew_ = std::move(isNew);
        isHalf_ = std::move(isHalf);
        whole_ = std::move(whole);
    }

    std::vector<Vec2>& points_;
    std::vector<CurvePiece>& pieces_;
    const SeparateOptions& options_;
    Execution& execution_;
    const std::vector<CurvePiece> wholePieces_; ///< as they were given
    const std::size_t wholePoints_;
    std::vector<Vec2> lonePoints_; ///< at no piece's end
    std::vector<Strand> strands_;  ///< by curve
    std::vector<std::uint8_t> followsGaps_; ///< by whole piece
    std::vector<std::uint32_t> parts_;      ///< by whole piece
    std::size_t halvesForGaps_ = 0;
    std::vector<CoarseGap> coarseGaps_;
    Vec2 lastConflict_;
    std::vector<std::uint32_t> whole_; ///< by piece: the one that it is a part of
    std::vector<std::uint8_t> isNew_;
    std::vector<std::uint8_t> isHalf_; ///< made here
    std::vector<std::uint8_t> marked_;
    std::vector<double> sagitta_;
    double scale_ = 0.0;
};

} // namespace

Separation separatePieces(std::vector<Vec2>& points, std::vector<CurvePiece>& pieces,
                          const SeparateOptions& options, Execution& execution)
{
    return PieceSeparator(points, pieces, options, execution).run();
}

} // namespace tessera
