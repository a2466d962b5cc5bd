// SPDX-License-Identifier: MIT
#include "occt/shape_network.h"

#include "base/number_text.h"
#include "occt/occt_curve.h"
#include "occt/shape_plane.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tessera
{
namespace
{

constexpr double kWeldPerVertexTolerance = 20.0;
constexpr double kWeldPerDiagonal = 1e-7;

/// "Edge3, Edge5, Edge6 and 12 more".
template<class NameOf>
std::string listOf(const std::vector<std::uint32_t>& numbers, NameOf&& nameOf)
{
    constexpr std::size_t kShown = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(kShown, numbers.size()); ++i) {
        text += (i == 0 ? "" : ", ") + nameOf(numbers[i]);
    }
    if (numbers.size() > kShown) {
        text += " and " + std::to_string(numbers.size() - kShown) + " more";
    }
    return text;
}

std::string faceName(std::uint32_t number)
{
    return "Face" + std::to_string(number);
}

bool isFinite(const gp_Pnt& p)
{
    return std::isfinite(p.X()) && std::isfinite(p.Y()) && std::isfinite(p.Z());
}

class ShapeReader
{
public:
    ShapeReader(const TopoDS_Shape& shape, const CadOptions& options);
    CadInput read();
    PlaneFrame plane();

private:
    struct EdgeData
    {
        EdgeCurve whole; ///< null curve: not used
        std::vector<EdgeCurve> pieces;
        std::vector<PointId> ends; ///< of the pieces, in the curve's own direction
    };

    void collectEdges();
    void measure();
    void choosePlane();
    void checkHeights() const;
    void addFace(int faceNumber);
    void addLooseEdges();
    void addEmbedded(const TopoDS_Shape& parent, OperandId operand);
    void addCurves(const TopoDS_Edge& edge, bool reversed, Role role, OperandId operand);
    void applyEdgeRoles();
    OperandId addOperand(const std::string& kind, bool only, bool declaresHoles);
    PointId pointOf(const TopoDS_Vertex& vertex);
    PointId endPoint(const TopoDS_Vertex& vertex, const gp_Pnt& curveEnd, std::uint32_t edge);
    void placeEnds(EdgeData& data, const TopoDS_Edge& edge, std::uint32_t edgeNumber);
    std::string edgeName(std::uint32_t edgeNumber) const;
    std::string namesOf(const std::vector<std::uint32_t>& edges) const;
    /// The edges' names, then the message.
    CadError refusal(const std::vector<std::uint32_t>& edges, const std::string& message) const;

    const TopoDS_Shape& shape_;
    const CadOptions& options_;
    TopTools_IndexedMapOfShape faces_;
    TopTools_IndexedMapOfShape edges_;
    TopTools_IndexedMapOfShape vertices_;
    std::vector<EdgeData> data_;          ///< by edge number; 0 unused
    std::vector<std::uint8_t> inFace_;    ///< by edge number
    std::vector<gp_Pnt> samples_;
    std::vector<std::uint32_t> sampleEdge_;
    std::vector<PointId> vertexPoint_;    ///< by vertex number
    std::map<std::pair<double, double>, PointId> pointAt_; ///< of vertices, by position
    std::vector<std::uint8_t> embedded_;  ///< by vertex number
    PlaneProjection projection_ {PlaneFrame {}};
    CadInput input_;
};

ShapeReader::ShapeReader(const TopoDS_Shape& shape, const CadOptions& options)
    : shape_(shape)
    , options_(options)
{
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    data_.resize(static_cast<std::size_t>(edges_.Extent()) + 1);
    inFace_.resize(data_.size(), 0);
    vertexPoint_.resize(static_cast<std::size_t>(vertices_.Extent()) + 1);
    embedded_.resize(vertexPoint_.size(), 0);
}

CadInput ShapeReader::read()
{
    collectEdges();
    measure();
    choosePlane();
    checkHeights();
    for (int i = 1; i <= faces_.Extent(); ++i) {
        addFace(i);
    }
    addLooseEdges();
    applyEdgeRoles();
    return std::move(input_);
}

PlaneFrame ShapeReader::plane()
{
    collectEdges();
    measure();
    choosePlane();
    return input_.frame;
}

std::string ShapeReader::namesOf(const std::vector<std::uint32_t>& edges) const
{
    return listOf(edges, [this](std::uint32_t edge) { return edgeName(edge); });
}

CadError ShapeReader::refusal(const std::vector<std::uint32_t>& edges,
                              const std::string& message) const
{
    std::vector<CadPlace> where;
    for (const std::uint32_t edge : edges) {
        const EdgeCurve& curve = data_[edge].whole;
        const gp_Pnt middle = curve.curve.IsNull()
            ? gp_Pnt()
            : curve.curve->Value(0.5 * (curve.first + curve.last));
        where.push_back({edge, {middle.X(), middle.Y(), middle.Z()}});
    }
    return {ErrorKind::InvalidInput, namesOf(edges) + message, std::move(where)};
}

void ShapeReader::collectEdges()
{
    for (TopExp_Explorer face(shape_, TopAbs_FACE); face.More(); face.Next()) {
        for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next()) {
            inFace_[static_cast<std::size_t>(edges_.FindIndex(edge.Current()))] = 1;
        }
    }
    std::vector<std::uint32_t> without;
    std::vector<std::uint32_t> infinite;
    for (std::uint32_t i = 1; i < data_.size(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges_(static_cast<int>(i)));
        const bool ignored = !inFace_[i] && options_.looseEdges == LooseEdges::Ignored;
        if (ignored || BRep_Tool::Degenerated(edge)) {
            continue;
        }
        EdgeCurve curve = curveOf(edge);
        if (curve.curve.IsNull()) {
            without.push_back(i);
        }
        else if (!(std::abs(curve.first) < Precision::Infinite())
                 || !(std::abs(curve.last) < Precision::Infinite())) {
            infinite.push_back(i);
        }
        else {
            data_[i].whole = std::move(curve);
        }
    }
    if (!without.empty()) {
        throw refusal(without, ": no curve in the shape; repair the shape.");
    }
    if (!infinite.empty()) {
        throw refusal(infinite, ": infinitely long; trim it.");
    }
}

/// Samples all edges; finds the weld tolerance.
void ShapeReader::measure()
{
    double vertexTolerance = 0.0;
    for (std::uint32_t i = 1; i < data_.size(); ++i) {
        if (data_[i].whole.curve.IsNull()) {
            continue;
        }
        for (const gp_Pnt& p : pointsAlong(data_[i].whole)) {
            if (!isFinite(p)) {
                throw CadError(ErrorKind::InvalidInput,
                               edgeName(i) + " has a coordinate that is not finite; redraw it.",
                               {{i, {}}});
            }
            samples_.push_back(p);
            sampleEdge_.push_back(i);
        }
        for (TopExp_Explorer v(edges_(static_cast<int>(i)), TopAbs_VERTEX); v.More(); v.Next()) {
            vertexTolerance = std::max(vertexTolerance,
                                       BRep_Tool::Tolerance(TopoDS::Vertex(v.Current())));
        }
    }
    for (TopExp_Explorer v(shape_, TopAbs_VERTEX, TopAbs_EDGE); v.More(); v.Next()) {
        samples_.push_back(BRep_Tool::Pnt(TopoDS::Vertex(v.Current())));
        sampleEdge_.push_back(0);
    }
    if (samples_.empty()) {
        throw CadError(ErrorKind::InvalidInput,
                       "The shape has no edges; choose a sketch or a planar face.");
    }
    gp_XYZ low = samples_.front().XYZ();
    gp_XYZ high = low;
    for (const gp_Pnt& p : samples_) {
        for (int axis = 1; axis <= 3; ++axis) {
            low.SetCoord(axis, std::min(low.Coord(axis), p.Coord(axis)));
            high.SetCoord(axis, std::max(high.Coord(axis), p.Coord(axis)));
        }
    }
    input_.defaultWeld = std::max(kWeldPerVertexTolerance * vertexTolerance,
                                  kWeldPerDiagonal * (high - low).Modulus());
}

void ShapeReader::choosePlane()
{
    std::vector<std::uint32_t> curved;
    double distance = 0.0;
    std::string kind;
    for (int i = 1; i <= faces_.Extent(); ++i) {
        const TopoDS_Face& face = TopoDS::Face(faces_(i));
        if (BRep_Tool::Surface(face).IsNull()) {
            throw CadError(ErrorKind::InvalidInput,
                           faceName(static_cast<std::uint32_t>(i))
                               + " has no surface, only a triangulation; choose a CAD face.");
        }
        if (!planeNormal(face, input_.defaultWeld)) {
            kind = curved.empty() ? surfaceKind(face) : kind;
            curved.push_back(static_cast<std::uint32_t>(i));
            distance = std::max(distance, curvedBy(face));
        }
    }
    if (!curved.empty()) {
        throw CadError(ErrorKind::InvalidInput,
                       listOf(curved, faceName) + ": " + kind + ", leaves its plane by up to "
                           + numberText(distance) + "; choose planar faces.");
    }
    TopoDS_Face first;
    if (faces_.Extent() > 0) {
        first = TopoDS::Face(faces_(1));
    }
    input_.frame = options_.plane ? *options_.plane
                                  : planeOf(first.IsNull() ? nullptr : &first, samples_,
                                            input_.defaultWeld);
    projection_ = PlaneProjection(input_.frame);
}

void ShapeReader::checkHeights() const
{
    std::map<std::uint32_t, double> outside;
    double greatest = 0.0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const double height = std::abs(projection_.height(samples_[i]));
        if (height > input_.defaultWeld) {
            double& most = outside[sampleEdge_[i]];
            most = std::max(most, height);
            greatest = std::max(greatest, height);
        }
    }
    if (outside.empty()) {
        return;
    }
    std::vector<std::uint32_t> numbers;
    for (const auto& [edge, height] : outside) {
        if (edge != 0) {
            numbers.push_back(edge);
        }
    }
    const std::string message = ": up to " + numberText(greatest) + " out of the plane"
        + (options_.plane ? "" : faces_.Extent() > 0 ? " of Face1" : " of the others")
        + "; choose faces and edges that lie in one plane.";
    throw numbers.empty() ? CadError(ErrorKind::InvalidInput, "A vertex" + message)
                          : refusal(numbers, message);
}

OperandId ShapeReader::addOperand(const std::string& kind, bool only, bool declaresHoles)
{
    std::string name = options_.name;
    if (name.empty() || !only) {
        name += (name.empty() ? "" : "_") + kind;
    }
    input_.network.operands.push_back({name, declaresHoles});
    return OperandId(input_.network.operands.size() - 1);
}

void ShapeReader::addFace(int faceNumber)
{
    TopoDS_Face face = TopoDS::Face(faces_(faceNumber));
    face.Orientation(TopAbs_FORWARD);
    const std::array<double, 3>& z = input_.frame.z;
    const gp_Dir normal = *planeNormal(face, input_.defaultWeld);
    const bool upsideDown = normal.X() * z[0] + normal.Y() * z[1] + normal.Z() * z[2] < 0.0;
    const bool only = faces_.Extent() == 1
        && std::find(inFace_.begin() + 1, inFace_.end(), 0) == inFace_.end();
    const OperandId operand = addOperand("Face" + std::to_string(faceNumber), only, true);

    TopTools_IndexedMapOfShape seen;
    TopTools_IndexedMapOfShape twice;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        (seen.Contains(e.Current()) ? twice : seen).Add(e.Current());
    }
    TopTools_IndexedMapOfShape done;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
        const bool slit = twice.Contains(edge);
        if (slit && done.Contains(edge)) {
            continue;
        }
        done.Add(edge);
        const TopAbs_Orientation way = edge.Orientation();
        const bool separates = !slit && (way == TopAbs_FORWARD || way == TopAbs_REVERSED);
        addCurves(edge, (way == TopAbs_REVERSED) != upsideDown,
                  separates ? Role::Boundary : Role::Constraint, operand);
    }
    addEmbedded(face, operand);
}

void ShapeReader::addEmbedded(const TopoDS_Shape& parent, OperandId operand)
{
    for (TopExp_Explorer v(parent, TopAbs_VERTEX, TopAbs_EDGE); v.More(); v.Next()) {
        const auto number = static_cast<std::size_t>(vertices_.FindIndex(v.Current()));
        if (embedded_[number]) {
            continue;
        }
        embedded_[number] = 1;
        const std::string name = number <= options_.vertexNames.size()
            ? options_.vertexNames[number - 1]
            : std::string();
        input_.network.embedded.push_back({pointOf(TopoDS::Vertex(v.Current())), operand, name});
    }
}

PointId ShapeReader::pointOf(const TopoDS_Vertex& vertex)
{
    PointId& id = vertexPoint_[static_cast<std::size_t>(vertices_.FindIndex(vertex))];
    if (!id.valid()) {
        // Edges of sketches have vertices of their own: what coincides was drawn so.
        const Vec2 p = projection_.point(BRep_Tool::Pnt(vertex));
        PointId& there = pointAt_[{p.x, p.y}];
        if (!there.valid()) {
            there = input_.network.addPoint(p);
        }
        id = there;
    }
    return id;
}

PointId ShapeReader::endPoint(const TopoDS_Vertex& vertex, const gp_Pnt& curveEnd,
                              std::uint32_t edge)
{
    if (vertex.IsNull()) {
        return input_.network.addPoint(projection_.point(curveEnd));
    }
    const double gap = BRep_Tool::Pnt(vertex).Distance(curveEnd);
    if (!(gap <= input_.defaultWeld)) {
        throw refusal({edge}, " ends " + numberText(gap) + " away from its vertex; repair the shape.");
    }
    return pointOf(vertex);
}

void ShapeReader::placeEnds(EdgeData& data, const TopoDS_Edge& edge, std::uint32_t edgeNumber)
{
    data.pieces = smoothPieces(data.whole);
    TopoDS_Vertex first;
    TopoDS_Vertex last;
    TopExp::Vertices(edge, first, last);
    const gp_Pnt start = data.whole.curve->Value(data.whole.first);
    const gp_Pnt end = data.whole.curve->Value(data.whole.last);
    data.ends.push_back(endPoint(first, start, edgeNumber));
    for (std::size_t i = 1; i < data.pieces.size(); ++i) {
        const EdgeCurve& piece = data.pieces[i];
        data.ends.push_back(
            input_.network.addPoint(projection_.point(piece.curve->Value(piece.first))));
    }
    const bool closed = last.IsNull() && start.Distance(end) <= input_.defaultWeld;
    data.ends.push_back(closed ? data.ends.front() : endPoint(last, end, edgeNumber));
}

void ShapeReader::addCurves(const TopoDS_Edge& edge, bool reversed, Role role, OperandId operand)
{
    const auto edgeNumber = static_cast<std::uint32_t>(edges_.FindIndex(edge));
    EdgeData& data = data_[edgeNumber];
    if (data.whole.curve.IsNull()) {
        return;
    }
    if (data.pieces.empty()) {
        placeEnds(data, TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), edgeNumber);
    }
    const std::size_t count = data.pieces.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = reversed ? count - 1 - k : k;
        const EdgeCurve& piece = data.pieces[i];
        NetworkCurve curve;
        curve.geometry = makeCurve(piece, reversed, projection_);
        curve.start = data.ends[reversed ? i + 1 : i];
        curve.end = data.ends[reversed ? i : i + 1];
        curve.operand = operand;
        curve.role = role;
        curve.source = edgeNumber;
        input_.network.curves.push_back(std::move(curve));
        input_.network.curveNames.push_back(edgeName(edgeNumber));
    }
}

std::string ShapeReader::edgeName(std::uint32_t edgeNumber) const
{
    if (edgeNumber <= options_.edgeNames.size() && !options_.edgeNames[edgeNumber - 1].empty()) {
        return options_.edgeNames[edgeNumber - 1];
    }
    return (options_.name.empty() ? "" : options_.name + "_") + "Edge"
        + std::to_string(edgeNumber);
}

void ShapeReader::addLooseEdges()
{
    std::vector<TopoDS_Edge> loose;
    for (TopExp_Explorer e(shape_, TopAbs_EDGE, TopAbs_FACE); e.More(); e.Next()) {
        const auto edgeNumber = static_cast<std::size_t>(edges_.FindIndex(e.Current()));
        if (!inFace_[edgeNumber]) {
            loose.push_back(TopoDS::Edge(e.Current()));
        }
    }
    bool points = false;
    for (TopExp_Explorer v(shape_, TopAbs_VERTEX, TopAbs_EDGE); v.More(); v.Next()) {
        points |= !embedded_[static_cast<std::size_t>(vertices_.FindIndex(v.Current()))];
    }
    if (options_.looseEdges == LooseEdges::Ignored || (loose.empty() && !points)) {
        return;
    }
    const OperandId operand = addOperand(loose.empty() ? "Points" : "Edges",
                                         faces_.Extent() == 0, false);
    const Role role = options_.looseEdges == LooseEdges::ByChain ? Role::Chain
        : options_.looseEdges == LooseEdges::Boundary            ? Role::Boundary
                                                                 : Role::Constraint;
    for (const TopoDS_Edge& edge : loose) {
        addCurves(edge, edge.Orientation() == TopAbs_REVERSED, role, operand);
    }
    addEmbedded(shape_, operand);
}

void ShapeReader::applyEdgeRoles()
{
    std::map<std::uint32_t, Role> roles;
    for (const auto& [edge, role] : options_.edgeRoles) {
        if (edge == 0 || edge >= data_.size()) {
            throw CadError(ErrorKind::InvalidOption,
                           "There is no Edge" + std::to_string(edge) + "; the shape has "
                               + std::to_string(data_.size() - 1)
                               + (data_.size() == 2 ? " edge." : " edges."));
        }
        roles[edge] = role;
    }
    for (NetworkCurve& curve : input_.network.curves) {
        if (const auto found = roles.find(curve.source); found != roles.end()) {
            curve.role = found->second;
        }
    }
}

template<class Read>
auto translated(Read&& read)
{
    try {
        return read();
    }
    catch (const Standard_Failure& failure) {
        throw CadError(ErrorKind::InvalidInput,
                       std::string("OpenCASCADE cannot use the shape (")
                           + failure.GetMessageString() + "); check and repair it.");
    }
}

} // namespace

CadInput networkFromShape(const TopoDS_Shape& shape, const CadOptions& options)
{
    if (shape.IsNull()) {
        throw CadError(ErrorKind::InvalidInput,
                       "The shape is empty; choose a sketch or a planar face.");
    }
    return translated([&] { return ShapeReader(shape, options).read(); });
}

PlaneFrame planeOfShapes(std::span<const TopoDS_Shape> shapes)
{
    return translated([&] {
        TopoDS_Compound all;
        BRep_Builder builder;
        builder.MakeCompound(all);
        for (const TopoDS_Shape& shape : shapes) {
            builder.Add(all, shape);
        }
        return ShapeReader(all, {}).plane();
    });
}

} // namespace tessera
