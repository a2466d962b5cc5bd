// SPDX-License-Identifier: MIT
#include "curve/network_check.h"

#include <cmath>

namespace tessera
{

namespace
{

class NetworkCheck
{
public:
    explicit NetworkCheck(const CurveNetwork& network)
        : network_(network)
    {}

    std::vector<NetworkProblem> run()
    {
        for (std::size_t i = 0; i < network_.points.size(); ++i) {
            if (!isFinite(network_.points[i])) {
                add("Point " + std::to_string(i)
                        + ", counted from 0, has a coordinate that is not finite.",
                    network_.points[i], ErrorPlace {}.curve);
            }
        }
        for (std::size_t c = 0; c < network_.curves.size(); ++c) {
            checkCurve(c, network_.curves[c]);
        }
        for (const EmbeddedPoint& embedded : network_.embedded) {
            checkPoint(embedded.point, "An embedded point");
            checkOperand(embedded.operand, "An embedded point", positionOf(embedded.point));
        }
        for (const HolePoint& hole : network_.holes) {
            checkPosition(hole.position, hole.operand, "A hole point");
        }
        for (const RegionPoint& region : network_.regions) {
            checkPosition(region.position, region.operand, "A region point");
            if (!std::isfinite(region.attribute) || !std::isfinite(region.maxArea)) {
                add("A region point has an attribute or area that is not finite.",
                    region.position, ErrorPlace {}.curve);
            }
        }
        return std::move(problems_);
    }

private:
    void add(const std::string& what, Vec2 place, std::uint32_t curve)
    {
        problems_.push_back({what, {place, curve}});
    }

    bool pointExists(PointId id) const { return id.index() < network_.points.size(); }
    Vec2 positionOf(PointId id) const
    {
        return pointExists(id) ? network_.points[id.index()] : Vec2 {};
    }

    void checkPoint(PointId id, const std::string& who)
    {
        if (!pointExists(id)) {
            add(who + " refers to a point that does not exist.", {}, ErrorPlace {}.curve);
        }
    }

    void checkOperand(OperandId id, const std::string& who, Vec2 place)
    {
        if (id.index() >= network_.operands.size()) {
            add(who + " belongs to an operand that does not exist.", place, ErrorPlace {}.curve);
        }
    }

    void checkPosition(Vec2 position, OperandId operand, const std::string& who)
    {
        if (!isFinite(position)) {
            add(who + " has a coordinate that is not finite.", position, ErrorPlace {}.curve);
        }
        checkOperand(operand, who, position);
    }

    void checkCurve(std::size_t index, const NetworkCurve& curve)
    {
        const auto id = static_cast<std::uint32_t>(index);
        const auto about = [index](const char* what) {
            return "Curve " + std::to_string(index) + ", counted from 0," + what;
        };
        if (!pointExists(curve.start) || !pointExists(curve.end)) {
            add(about(" ends at a point that does not exist."), {}, id);
        }
        if (curve.operand.index() >= network_.operands.size()) {
            add(about(" belongs to an operand that does not exist."), positionOf(curve.start), id);
        }
        if (!curve.geometry) {
            return;
        }
        const double first = curve.geometry->first();
        const double last = curve.geometry->last();
        if (!std::isfinite(first) || !std::isfinite(last) || !(first < last)) {
            add(about(" has no finite parameter range."), positionOf(curve.start), id);
        }
        else if (!isFinite(curve.geometry->point(first))
                 || !isFinite(curve.geometry->point(last))) {
            add(about(" has an end that is not finite."), positionOf(curve.start), id);
        }
    }

    const CurveNetwork& network_;
    std::vector<NetworkProblem> problems_;
};

} // namespace

std::vector<NetworkProblem> findProblems(const CurveNetwork& network)
{
    return NetworkCheck(network).run();
}

void requireValid(const CurveNetwork& network)
{
    const std::vector<NetworkProblem> problems = findProblems(network);
    if (problems.empty()) {
        return;
    }
    std::string message = problems.front().what;
    if (problems.size() > 1) {
        message += " There are " + std::to_string(problems.size() - 1) + " more such problems.";
    }
    std::vector<ErrorPlace> places;
    for (const NetworkProblem& problem : problems) {
        places.push_back(problem.place);
    }
    throw Error(ErrorKind::InvalidInput, message, std::move(places));
}

} // namespace tessera
