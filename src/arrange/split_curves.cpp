// SPDX-License-Identifier: MIT
#include "arrange/split_curves.h"

#include "curve/curve_tools.h"
#include "curve/curve_views.h"

#include <algorithm>
#include <string>
#include <utility>

namespace tessera
{

namespace
{

/// A point on a curve, in the order of parameters.
struct Stop
{
    double t;
    PointId point;
};

class CurveSplitter
{
public:
    CurveSplitter(CurveNetwork& network, double shortest, ArrangeReport& report)
        : network_(network)
        , shortest_(shortest)
        , report_(report)
    {}

    std::vector<PieceOrigin> run(std::vector<CurveSplit> splits)
    {
        std::stable_sort(splits.begin(), splits.end(),
                         [](const CurveSplit& a, const CurveSplit& b) {
                             return a.curve != b.curve ? a.curve < b.curve : a.t < b.t;
                         });
        std::size_t next = 0;
        std::vector<Stop> stops;
        for (std::uint32_t c = 0; c < network_.curves.size(); ++c) {
            stops.clear();
            for (; next < splits.size() && splits[next].curve == c; ++next) {
                stops.push_back({splits[next].t, splits[next].point});
            }
            addPieces(c, stops);
        }
        network_.curves = std::move(pieces_);
        network_.curveNames = std::move(names_);
        report_.parent = std::move(parents_);
        return std::move(origins_);
    }

private:
    static double firstOf(const NetworkCurve& curve)
    {
        return curve.geometry ? curve.geometry->first() : 0.0;
    }
    static double lastOf(const NetworkCurve& curve)
    {
        return curve.geometry ? curve.geometry->last() : 1.0;
    }

    bool isShort(const NetworkCurve& curve, double t0, double t1) const
    {
        if (!curve.geometry) {
            const Vec2 a = network_.points[curve.start.index()];
            const Vec2 b = network_.points[curve.end.index()];
            return (t1 - t0) * distance(a, b) <= shortest_;
        }
        return distance(curve.geometry->point(t0), curve.geometry->point(t1)) <= shortest_
            && arcLength(*curve.geometry, t0, t1) <= shortest_;
    }

    void addPieces(std::uint32_t c, const std::vector<Stop>& inner)
    {
        const NetworkCurve curve = network_.curves[c];
        if (inner.empty()) {
            add(curve, c, firstOf(curve), lastOf(curve));
            return;
        }
        std::vector<Stop> stops {{firstOf(curve), curve.start}};
        for (const Stop& stop : inner) {
            if (stop.point != stops.back().point || !isShort(curve, stops.back().t, stop.t)) {
                stops.push_back(stop);
            }
        }
        // The end stays; what is too close before it goes, but never the start.
        const Stop last {lastOf(curve), curve.end};
        while (stops.size() > 1 && stops.back().point == last.point
               && isShort(curve, stops.back().t, last.t)) {
            stops.pop_back();
        }
        stops.push_back(last);
        const bool whole = stops.size() == 2;
        for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
            NetworkCurve piece = curve;
            piece.start = stops[i].point;
            piece.end = stops[i + 1].point;
            const double t0 = stops[i].t;
            const double t1 = stops[i + 1].t;
            if (!(t0 < t1)) {
                piece.geometry = nullptr; // two points at one place of the curve
            }
            else if (piece.geometry && !whole) {
                piece.geometry = std::make_shared<TrimmedCurve>(curve.geometry, t0, t1);
            }
            add(piece, c, t0, t1);
        }
    }

    void add(const NetworkCurve& piece, std::uint32_t c, double t0, double t1)
    {
        pieces_.push_back(piece);
        parents_.push_back(report_.parent[c]);
        origins_.push_back({c, t0, t1});
        if (!network_.curveNames.empty()) {
            names_.push_back(c < network_.curveNames.size() ? network_.curveNames[c] : "");
        }
    }

    CurveNetwork& network_;
    double shortest_;
    ArrangeReport& report_;
    std::vector<NetworkCurve> pieces_;
    std::vector<CurveId> parents_;
    std::vector<std::string> names_;
    std::vector<PieceOrigin> origins_;
};

} // namespace

std::vector<PieceOrigin> splitCurves(CurveNetwork& network, std::vector<CurveSplit> splits,
                                     double shortest, ArrangeReport& report)
{
    return CurveSplitter(network, shortest, report).run(std::move(splits));
}

} // namespace tessera
