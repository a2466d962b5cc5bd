// SPDX-License-Identifier: MIT
#pragma once

// An independent oracle: the arrangement of a few segments by brute force in exact rationals.

#include "recover/recovery_case.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace tessera::test
{

using Rational = boost::multiprecision::cpp_rational;
using ExactPoint = std::pair<Rational, Rational>;

inline ExactPoint exactPoint(Vec2 p)
{
    return {Rational(p.x), Rational(p.y)};
}

/// The double nearest to a rational, ties to even.
inline double nearestDouble(const Rational& value)
{
    double result = value.convert_to<double>();
    const auto error
        = [&](double candidate) -> Rational { return abs(Rational(candidate) - value); };
    for (const double direction : {-1.0, 1.0}) {
        for (;;) {
            const double next
                = std::nextafter(result, direction * std::numeric_limits<double>::infinity());
            const Rational here = error(result);
            const Rational there = error(next);
            const bool even = (std::bit_cast<std::uint64_t>(next) & 1U) == 0;
            if (there < here || (there == here && even)) {
                result = next;
            }
            else {
                break;
            }
        }
    }
    return result;
}

inline Vec2 nearestPoint(const ExactPoint& p)
{
    return {nearestDouble(p.first), nearestDouble(p.second)};
}

struct ExactArrangement
{
    std::vector<ExactPoint> vertices;            ///< sorted
    std::vector<std::vector<ExactPoint>> chains; ///< by segment, from its first point to its second
    std::size_t crossings = 0;                   ///< vertices that are no input points
    std::size_t edges = 0;                       ///< different pieces
    /// Least distance between vertices and between a vertex and a segment that it is not on,
    /// over the size of the input.
    double separation = std::numeric_limits<double>::infinity();
};

class ExactArranger
{
public:
    explicit ExactArranger(const RawPslg& raw)
        : raw_(raw)
    {
        for (const Vec2 p : raw.points) {
            points_.push_back(exactPoint(p));
        }
    }

    ExactArrangement run()
    {
        std::set<ExactPoint> input(points_.begin(), points_.end());
        std::set<ExactPoint> all = input;
        const std::size_t n = raw_.segments.size();
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                addCrossing(i, j, all);
            }
        }
        ExactArrangement result;
        result.vertices.assign(all.begin(), all.end());
        result.crossings = all.size() - input.size();
        std::set<std::pair<ExactPoint, ExactPoint>> edges;
        for (std::size_t i = 0; i < n; ++i) {
            result.chains.push_back(chain(i, result.vertices));
            const auto& c = result.chains.back();
            for (std::size_t k = 1; k < c.size(); ++k) {
                edges.insert(std::minmax(c[k - 1], c[k]));
            }
        }
        result.edges = edges.size();
        measure(result);
        return result;
    }

private:
    const ExactPoint& start(std::size_t i) const { return points_[raw_.segments[i].first]; }
    const ExactPoint& end(std::size_t i) const { return points_[raw_.segments[i].second]; }

    static Rational cross(const ExactPoint& o, const ExactPoint& a, const ExactPoint& b)
    {
        return (a.first - o.first) * (b.second - o.second)
            - (a.second - o.second) * (b.first - o.first);
    }
    bool isOn(std::size_t i, const ExactPoint& p) const
    {
        return cross(start(i), end(i), p) == 0 && std::min(start(i), end(i)) <= p
            && p <= std::max(start(i), end(i));
    }

    void addCrossing(std::size_t i, std::size_t j, std::set<ExactPoint>& all) const
    {
        const Rational c = cross(start(i), end(i), start(j));
        const Rational d = cross(start(i), end(i), end(j));
        if (c == d) {
            return; // parallel
        }
        const Rational t = c / (c - d);
        const ExactPoint p {start(j).first + t * (end(j).first - start(j).first),
                            start(j).second + t * (end(j).second - start(j).second)};
        if (isOn(i, p) && isOn(j, p)) {
            all.insert(p);
        }
    }

    std::vector<ExactPoint> chain(std::size_t i, const std::vector<ExactPoint>& vertices) const
    {
        std::vector<ExactPoint> result;
        for (const ExactPoint& p : vertices) {
            if (isOn(i, p)) {
                result.push_back(p);
            }
        }
        if (start(i) > end(i)) {
            std::reverse(result.begin(), result.end());
        }
        return result;
    }

    void measure(ExactArrangement& result) const
    {
        Rational size = 0;
        for (const ExactPoint& p : points_) {
            size = std::max({size, Rational(abs(p.first - points_[0].first)),
                             Rational(abs(p.second - points_[0].second))});
        }
        const double unit = size.convert_to<double>();
        const auto note = [&](double distance) {
            result.separation = std::min(result.separation, distance / unit);
        };
        const auto difference = [](const ExactPoint& p, const ExactPoint& q) {
            return Vec2 {Rational(q.first - p.first).convert_to<double>(),
                         Rational(q.second - p.second).convert_to<double>()};
        };
        for (std::size_t v = 0; v < result.vertices.size(); ++v) {
            const ExactPoint& p = result.vertices[v];
            for (std::size_t w = 0; w < v; ++w) {
                note(length(difference(p, result.vertices[w])));
            }
            for (std::size_t i = 0; i < raw_.segments.size(); ++i) {
                const Rational area = cross(start(i), end(i), p);
                if (area != 0) {
                    // The distance to the line is a lower bound of that to the segment.
                    note(std::fabs(area.convert_to<double>())
                         / length(difference(start(i), end(i))));
                }
            }
        }
    }

    const RawPslg& raw_;
    std::vector<ExactPoint> points_;
};

inline ExactArrangement exactArrangement(const RawPslg& raw)
{
    return ExactArranger(raw).run();
}

} // namespace tessera::test
