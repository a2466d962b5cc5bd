// SPDX-License-Identifier: MIT
#include "python/network_input.h"

#include "curve/default_roles.h"
#include "io/append_network.h"
#include "occt/read_cad.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace py = pybind11;

namespace tessera::python
{
namespace
{

[[noreturn]] void refuse(const std::string& message)
{
    raise(Error(ErrorKind::InvalidInput, message), {}, {});
}

std::vector<Vec2> pointsFrom(const Coordinates& array, const std::string& what)
{
    if (array.size() > 0 && (array.ndim() != 2 || array.shape(1) != 2)) {
        refuse(what + " must be an array of shape (n, 2).");
    }
    std::vector<Vec2> points(array.size() > 0 ? static_cast<std::size_t>(array.shape(0)) : 0);
    const double* data = array.data();
    for (Vec2& point : points) {
        point = {data[0], data[1]};
        data += 2;
    }
    return points;
}

/// Of several polygons, which one it is; the network knows a point by its number in all of them.
void requireFinite(const std::vector<Vec2>& points, const std::string& name)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isFinite(points[i])) {
            refuse(name + ": point " + std::to_string(i)
                   + ", counted from 0, has a coordinate that is not finite.");
        }
    }
}

void embedUnusedPoints(CurveNetwork& network, OperandId operand)
{
    std::vector<std::uint8_t> used(network.points.size(), 0);
    for (const NetworkCurve& curve : network.curves) {
        used[curve.start.index()] = 1;
        used[curve.end.index()] = 1;
    }
    for (std::uint32_t i = 0; i < used.size(); ++i) {
        if (used[i] == 0) {
            network.embedded.push_back({PointId(i), operand, {}});
        }
    }
}

/// Adds the time of a scope to a sum.
class Stopwatch
{
public:
    explicit Stopwatch(double& sum)
        : sum_(sum)
    {}
    ~Stopwatch()
    {
        sum_ += std::chrono::duration<double>(Clock::now() - begin_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    using Clock = std::chrono::steady_clock;

    double& sum_;
    Clock::time_point begin_ = Clock::now();
};

} // namespace

void NetworkInput::beginSource(const std::string& kind, std::vector<std::string> elements)
{
    sources_.push_back({network_.curves.size(), network_.operands.size(), kind, std::move(elements)});
}

PlaceName NetworkInput::nameOf(std::size_t source, std::uint32_t number) const
{
    const Source& from = sources_[source];
    const std::size_t index = from.kind == "Edge" ? number - 1 : number;
    std::string element = index < from.elements.size() && !from.elements[index].empty()
        ? from.elements[index]
        : from.kind + std::to_string(number);
    PlaceName name;
    name.element = std::move(element);
    name.source = static_cast<std::int64_t>(source);
    return name;
}

void NetworkInput::joinOperands()
{
    std::vector<OperandId> joined(network_.operands.size());
    std::vector<Operand> operands;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        const std::size_t first = sources_[i].firstOperand;
        const std::size_t end =
            i + 1 < sources_.size() ? sources_[i + 1].firstOperand : joined.size();
        for (std::size_t o = first; o < end; ++o) {
            joined[o] = OperandId(operands.size());
        }
        sources_[i].firstOperand = operands.size();
        if (first < end) {
            operands.push_back(network_.operands[first]);
        }
    }
    for (NetworkCurve& curve : network_.curves) {
        curve.operand = joined[curve.operand.index()];
    }
    for (EmbeddedPoint& point : network_.embedded) {
        point.operand = joined[point.operand.index()];
    }
    network_.operands = std::move(operands); // arrays and shapes have no holes or regions
}

std::vector<std::uint32_t> NetworkInput::curvesOf(std::size_t source, std::int64_t number) const
{
    const std::size_t end = source + 1 < sources_.size() ? sources_[source + 1].firstCurve
                                                         : network_.curves.size();
    std::vector<std::uint32_t> curves;
    for (std::size_t c = source < sources_.size() ? sources_[source].firstCurve : end; c < end;
         ++c) {
        if (number < 0 || network_.curves[c].source == number) {
            curves.push_back(static_cast<std::uint32_t>(c));
        }
    }
    return curves;
}

std::vector<std::uint32_t> NetworkInput::operandsOf(std::size_t source) const
{
    std::vector<std::uint32_t> operands;
    for (const std::uint32_t c : curvesOf(source, -1)) {
        operands.push_back(network_.curves[c].operand.value);
    }
    std::sort(operands.begin(), operands.end());
    operands.erase(std::unique(operands.begin(), operands.end()), operands.end());
    return operands;
}

std::array<double, 2> NetworkInput::toPlane(const std::array<double, 3>& point) const
{
    std::array<double, 2> result {};
    for (std::size_t i = 0; i < 3; ++i) {
        const double offset = point[i] - frame_.origin[i];
        result[0] += offset * frame_.x[i];
        result[1] += offset * frame_.y[i];
    }
    return result;
}

void NetworkInput::raise(const Error& error) const
{
    std::vector<PlaceName> names;
    for (const ErrorPlace& place : error.places()) {
        PlaceName name;
        if (place.curve < network_.curves.size()) {
            const auto after = std::upper_bound(
                sources_.begin(), sources_.end(), place.curve,
                [](std::uint32_t curve, const Source& s) { return curve < s.firstCurve; });
            name = nameOf(static_cast<std::size_t>(after - sources_.begin()) - 1,
                          network_.curves[place.curve].source);
            if (place.curve < network_.curveNames.size()) {
                name.curve = network_.curveNames[place.curve];
            }
        }
        names.push_back(std::move(name));
    }
    python::raise(error, names, frame_);
}

void NetworkInput::addShapes(const std::vector<Shape>& shapes, bool flat)
{
    const Stopwatch stopwatch(seconds_);
    std::vector<BrepText> texts;
    for (const Shape& shape : shapes) {
        CadOptions options;
        if (flat) {
            options.plane = PlaneFrame {};
        }
        options.looseEdges = shape.looseEdges;
        options.name = shape.name;
        options.edgeNames = shape.edgeNames;
        options.vertexNames = shape.vertexNames;
        options.edgeRoles = shape.roles;
        texts.push_back({shape.brep, std::move(options),
                         shape.name.empty() ? std::string("shape") : shape.name});
    }
    const std::size_t firstSource = sources_.size();
    const std::size_t before = network_.curves.size();
    const std::size_t operandsBefore = network_.operands.size();
    try {
        std::vector<CadInput> inputs;
        {
            const py::gil_scoped_release release;
            inputs = readBrepTexts(texts);
        }
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            beginSource("Edge", shapes[i].elements);
            frame_ = inputs[i].frame;
            defaultWeld_ = std::max(defaultWeld_, inputs[i].defaultWeld);
            appendNetwork(network_, std::move(inputs[i].network));
        }
    }
    catch (const CadError& error) {
        sources_.resize(firstSource);
        for (const Shape& shape : shapes) {
            sources_.push_back({before, operandsBefore, "Edge", shape.elements});
        }
        std::vector<PlaceName> names;
        for (const CadPlace& place : error.where()) {
            names.push_back(place.edge == 0 ? PlaceName {}
                                            : nameOf(firstSource + error.shape(), place.edge));
            names.back().point = place.point;
        }
        python::raise(error, names, frame_);
    }
    catch (const Error& error) {
        python::raise(error, {}, frame_);
    }
}

void NetworkInput::addSegments(const Coordinates& points, const Indices& segments,
                               const Indices& markers, const std::string& name, const Roles& roles)
{
    const Stopwatch stopwatch(seconds_);
    if (segments.size() > 0 && (segments.ndim() != 2 || segments.shape(1) != 2)) {
        refuse("segments must be an array of shape (m, 2) of point indices.");
    }
    const std::size_t count = segments.size() > 0 ? static_cast<std::size_t>(segments.shape(0)) : 0;
    if (markers.size() > 0 && static_cast<std::size_t>(markers.size()) != count) {
        refuse("markers must have one number for each segment.");
    }
    CurveNetwork network;
    network.points = pointsFrom(points, "points");
    network.operands.push_back({name});
    const auto pointCount = static_cast<std::int64_t>(network.points.size());
    const OperandId operand(std::uint32_t {0});
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t a = segments.data()[2 * i];
        const std::int64_t b = segments.data()[2 * i + 1];
        if (a < 0 || b < 0 || a >= pointCount || b >= pointCount) {
            refuse("segments[" + std::to_string(i) + "] = (" + std::to_string(a) + ", "
                   + std::to_string(b) + ") names a point that does not exist; there are "
                   + std::to_string(pointCount) + ", counted from 0.");
        }
        NetworkCurve curve;
        curve.start = PointId(static_cast<std::uint32_t>(a));
        curve.end = PointId(static_cast<std::uint32_t>(b));
        curve.operand = operand;
        curve.source = static_cast<std::uint32_t>(i);
        if (markers.size() > 0) {
            const std::int64_t marker = markers.data()[i];
            if (marker != static_cast<std::int32_t>(marker)) {
                refuse("markers[" + std::to_string(i) + "] does not fit into 32 bits.");
            }
            curve.marker = static_cast<std::int32_t>(marker);
        }
        network.curves.push_back(std::move(curve));
    }
    std::vector<std::uint8_t> settled(count, 0);
    for (const auto& [segment, role] : roles) {
        if (segment >= count) {
            raise(Error(ErrorKind::InvalidOption,
                        "There is no segment " + std::to_string(segment) + "; there are "
                            + std::to_string(count) + ", counted from 0."));
        }
        network.curves[segment].role = role;
        settled[segment] = 1;
    }
    assignPolyRolesExcept(network, operand, settled);
    embedUnusedPoints(network, operand);
    beginSource("Segment", {});
    appendNetwork(network_, std::move(network));
}

void NetworkInput::addPolygon(const std::vector<Coordinates>& rings, const std::string& name,
                              Role role)
{
    const Stopwatch stopwatch(seconds_);
    CurveNetwork network;
    network.operands.push_back({name, true});
    for (const Coordinates& ring : rings) {
        std::vector<Vec2> points = pointsFrom(ring, "a polygon");
        requireFinite(points, name);
        if (points.size() > 1 && points.front() == points.back()) {
            points.pop_back();
        }
        if (points.size() < 3) {
            refuse(name + " has " + std::to_string(points.size())
                   + (points.size() == 1 ? " point" : " points")
                   + "; a polygon needs at least 3 different ones.");
        }
        const auto first = static_cast<std::uint32_t>(network.points.size());
        const auto count = static_cast<std::uint32_t>(points.size());
        network.points.insert(network.points.end(), points.begin(), points.end());
        for (std::uint32_t i = 0; i < count; ++i) {
            NetworkCurve curve;
            curve.start = PointId(first + i);
            curve.end = PointId(first + (i + 1) % count);
            curve.operand = OperandId(std::uint32_t {0});
            curve.role = role;
            curve.source = first + i;
            network.curves.push_back(std::move(curve));
            network.curveNames.push_back(name + "_Border");
        }
    }
    beginSource("Segment", {});
    appendNetwork(network_, std::move(network));
}

} // namespace tessera::python
