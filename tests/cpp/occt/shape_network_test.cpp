// SPDX-License-Identifier: MIT
#include "occt/shape_network.h"

#include "network_measures.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <numbers>

using namespace tessera;
using namespace tessera::test;
using std::numbers::pi;

namespace
{

TopoDS_Wire polygon(std::initializer_list<gp_Pnt> points)
{
    BRepBuilderAPI_MakePolygon maker;
    for (const gp_Pnt& p : points) {
        maker.Add(p);
    }
    maker.Close();
    return maker.Wire();
}

TopoDS_Wire square(double side)
{
    return polygon({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}});
}

TopoDS_Wire circle(double x, double y, double radius)
{
    const gp_Circ curve(gp_Ax2(gp_Pnt(x, y, 0), gp::DZ()), radius);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve).Edge()).Wire();
}

/// A square of side 10 with a round hole of radius 2.
TopoDS_Face plate()
{
    BRepBuilderAPI_MakeFace maker(square(10), true);
    maker.Add(TopoDS::Wire(circle(5, 5, 2).Reversed()));
    return maker.Face();
}

TopoDS_Compound compound(std::initializer_list<TopoDS_Shape> shapes)
{
    TopoDS_Compound result;
    BRep_Builder builder;
    builder.MakeCompound(result);
    for (const TopoDS_Shape& shape : shapes) {
        builder.Add(result, shape);
    }
    return result;
}

Handle(Geom_BSplineCurve) spline(int degree, std::initializer_list<gp_Pnt> poles,
                                 std::initializer_list<double> knots,
                                 std::initializer_list<int> multiplicities)
{
    TColgp_Array1OfPnt p(1, static_cast<int>(poles.size()));
    TColStd_Array1OfReal k(1, static_cast<int>(knots.size()));
    TColStd_Array1OfInteger m(1, static_cast<int>(knots.size()));
    int i = 1;
    for (const gp_Pnt& pole : poles) {
        p.SetValue(i++, pole);
    }
    i = 1;
    for (const double knot : knots) {
        k.SetValue(i++, knot);
    }
    i = 1;
    for (const int multiplicity : multiplicities) {
        m.SetValue(i++, multiplicity);
    }
    return new Geom_BSplineCurve(p, k, m, degree);
}

gp_Trsf tilted()
{
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 0.5)), 1.1);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(100, -20, 55));
    return move * turn;
}

} // namespace

TEST(ShapeNetwork, StraightEdgesHaveNoGeometryAndShareVertices)
{
    const CadInput input = networkFromShape(BRepBuilderAPI_MakeFace(square(10), true).Face());
    ASSERT_EQ(input.network.curves.size(), 4U);
    EXPECT_EQ(input.network.points.size(), 4U);
    for (const NetworkCurve& curve : input.network.curves) {
        EXPECT_EQ(curve.geometry, nullptr);
        EXPECT_EQ(curve.role, Role::Boundary);
    }
    EXPECT_DOUBLE_EQ(enclosedArea(input.network), 100.0);
    EXPECT_TRUE(boundaryIsClosed(input.network));
    EXPECT_EQ(input.frame, PlaneFrame {});
    EXPECT_DOUBLE_EQ(input.defaultWeld, 20 * 1e-7);
    EXPECT_EQ(input.network.operands[0].name, "Face1");
    EXPECT_TRUE(input.network.operands[0].declaresHoles);
    EXPECT_EQ(input.network.curveNames,
              (std::vector<std::string> {"Edge1", "Edge2", "Edge3", "Edge4"}));
    EXPECT_EQ(input.network.curves[2].source, 3U);
}

TEST(ShapeNetwork, FullCircleStartsAndEndsAtOnePoint)
{
    const CadInput input = networkFromShape(circle(3, 4, 2));
    ASSERT_EQ(input.network.curves.size(), 1U);
    const NetworkCurve& curve = input.network.curves[0];
    EXPECT_EQ(curve.start, curve.end);
    EXPECT_EQ(input.network.points.size(), 1U);
    EXPECT_EQ(curve.role, Role::Chain);
    EXPECT_NEAR(sweptArea(input.network, curve), 4 * pi, 1e-11);
    EXPECT_DOUBLE_EQ(curve.geometry->secondDerivativeBound(0.0, 1.0), 2.0);
    EXPECT_LT(greatestEndGap(input.network), 1e-14);
}

TEST(ShapeNetwork, HoleRunsClockwise)
{
    const CadInput input = networkFromShape(plate());
    EXPECT_EQ(input.network.operands.size(), 1U);
    EXPECT_TRUE(boundaryIsClosed(input.network));
    EXPECT_NEAR(enclosedArea(input.network), 100 - 4 * pi, 1e-11);
}

TEST(ShapeNetwork, ReversedFaceKeepsItsWinding)
{
    const CadInput input = networkFromShape(plate().Reversed());
    EXPECT_NEAR(enclosedArea(input.network), 100 - 4 * pi, 1e-11);
    EXPECT_EQ(input.frame, PlaneFrame {});
}

TEST(ShapeNetwork, PlacedFaceComesWithItsFrame)
{
    for (const bool reversed : {false, true}) {
        const TopoDS_Shape original = reversed ? plate().Reversed() : TopoDS_Shape(plate());
        const TopoDS_Shape placed = BRepBuilderAPI_Transform(original, tilted(), true).Shape();
        const TopoDS_Shape located = original.Located(TopLoc_Location(tilted()));
        for (const TopoDS_Shape& shape : {placed, located}) {
            const CadInput input = networkFromShape(shape);
            EXPECT_NEAR(enclosedArea(input.network), 100 - 4 * pi, 1e-10);
            gp_Pnt corner(0, 0, 0);
            corner.Transform(tilted());
            double nearest = 1e30;
            for (const Vec2 p : input.network.points) {
                const auto s = input.frame.toSpace(p);
                nearest = std::min(nearest, corner.Distance({s[0], s[1], s[2]}));
            }
            EXPECT_LT(nearest, 1e-12 * 100);
            const gp_Dir up = gp_Dir(0, 0, reversed ? -1 : 1).Transformed(tilted());
            EXPECT_NEAR(up.X(), input.frame.z[0], 1e-14);
            EXPECT_NEAR(up.Y(), input.frame.z[1], 1e-14);
            EXPECT_NEAR(up.Z(), input.frame.z[2], 1e-14);
        }
    }
}

TEST(ShapeNetwork, GivenPlaneIsUsed)
{
    gp_Trsf turn;
    turn.SetRotation(gp::OX(), pi / 2); // x-y to x-z, normal -y
    CadOptions options;
    options.plane = PlaneFrame {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    const CadInput input = networkFromShape(plate().Located(TopLoc_Location(turn)), options);
    EXPECT_EQ(input.frame, *options.plane);
    EXPECT_NEAR(enclosedArea(input.network), 100 - 4 * pi, 1e-11);
    options.plane->origin[1] = 0.25;
    try {
        networkFromShape(plate().Located(TopLoc_Location(turn)), options);
        FAIL() << "a face beside the given plane was accepted";
    }
    catch (const CadError& error) {
        EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
        EXPECT_NE(std::string(error.what()).find("0.25"), std::string::npos) << error.what();
        EXPECT_EQ(error.where().size(), 5U);
    }
}

TEST(ShapeNetwork, HorizontalShapesKeepGlobalCoordinates)
{
    gp_Trsf move;
    move.SetTranslation(gp_Vec(7, 8, 9));
    const CadInput input = networkFromShape(square(10).Located(TopLoc_Location(move)));
    EXPECT_EQ(input.frame.origin, (std::array<double, 3> {0, 0, 9}));
    EXPECT_EQ(input.network.points[0], (Vec2 {7, 8}));
}

TEST(ShapeNetwork, FacesThatShareAnEdgeAreTwoOperandsWithSharedPoints)
{
    const gp_Pnt a(0, 0, 0);
    const gp_Pnt b(0, 5, 0);
    const TopoDS_Vertex va = BRepBuilderAPI_MakeVertex(a);
    const TopoDS_Vertex vb = BRepBuilderAPI_MakeVertex(b);
    const TopoDS_Edge shared = BRepBuilderAPI_MakeEdge(va, vb);
    const auto half = [&](double x) {
        const TopoDS_Vertex vc = BRepBuilderAPI_MakeVertex(gp_Pnt(x, 2, 0));
        BRepBuilderAPI_MakeWire wire(shared, BRepBuilderAPI_MakeEdge(vb, vc).Edge(),
                                     BRepBuilderAPI_MakeEdge(vc, va).Edge());
        return BRepBuilderAPI_MakeFace(gp_Pln(a, gp::DZ()), wire.Wire()).Face();
    };
    const CadInput input = networkFromShape(compound({half(4), half(-6)}), {.name = "Part"});
    EXPECT_EQ(input.network.operands.size(), 2U);
    EXPECT_EQ(input.network.operands[1].name, "Part_Face2");
    EXPECT_EQ(input.network.curves.size(), 6U);
    EXPECT_EQ(input.network.points.size(), 4U);
    int onShared = 0;
    for (std::size_t i = 0; i < input.network.curves.size(); ++i) {
        onShared += input.network.curveNames[i] == "Part_Edge1" ? 1 : 0;
    }
    EXPECT_EQ(onShared, 2);
    EXPECT_DOUBLE_EQ(std::abs(enclosedArea(input.network)), 25.0);
}

TEST(ShapeNetwork, SlitAndInnerEdgesAreConstraints)
{
    const gp_Pln plane(gp_Pnt(0, 0, 0), gp::DZ());
    const TopoDS_Edge slit = BRepBuilderAPI_MakeEdge(gp_Pnt(5, 5, 0), gp_Pnt(7, 5, 0));
    const TopoDS_Edge inner = BRepBuilderAPI_MakeEdge(gp_Pnt(2, 2, 0), gp_Pnt(3, 2, 0));
    TopoDS_Face face = BRepBuilderAPI_MakeFace(plane, square(10)).Face();
    BRep_Builder builder;
    TopoDS_Wire slitWire;
    builder.MakeWire(slitWire);
    builder.Add(slitWire, slit);
    builder.Add(slitWire, slit.Reversed());
    builder.Add(face, slitWire);
    TopoDS_Wire innerWire;
    builder.MakeWire(innerWire);
    builder.Add(innerWire, inner.Oriented(TopAbs_INTERNAL));
    builder.Add(face, innerWire);
    const TopoDS_Vertex point = BRepBuilderAPI_MakeVertex(gp_Pnt(8, 8, 0));
    builder.Add(face, point.Oriented(TopAbs_INTERNAL));

    const CadInput input = networkFromShape(face);
    int constraints = 0;
    for (const NetworkCurve& curve : input.network.curves) {
        constraints += curve.role == Role::Constraint ? 1 : 0;
    }
    EXPECT_EQ(input.network.curves.size(), 6U);
    EXPECT_EQ(constraints, 2);
    EXPECT_DOUBLE_EQ(enclosedArea(input.network), 100.0);
    ASSERT_EQ(input.network.embedded.size(), 1U);
    EXPECT_EQ(input.network.points[input.network.embedded[0].point.index()], (Vec2 {8, 8}));
}

TEST(ShapeNetwork, LooseEdgesFormOneOperandBesideTheFaces)
{
    const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 0), gp_Pnt(2, 9, 0));
    const TopoDS_Vertex point = BRepBuilderAPI_MakeVertex(gp_Pnt(9, 9, 0));
    const TopoDS_Shape shape = compound({plate(), line, point});
    CadOptions options;
    options.vertexNames.resize(20, "Load");
    CadInput input = networkFromShape(shape, options);
    ASSERT_EQ(input.network.operands.size(), 2U);
    EXPECT_EQ(input.network.operands[0].name, "Face1");
    EXPECT_EQ(input.network.operands[1].name, "Edges");
    EXPECT_EQ(input.network.curves.back().role, Role::Chain);
    ASSERT_EQ(input.network.embedded.size(), 1U);
    EXPECT_EQ(input.network.embedded[0].name, "Load");

    options.looseEdges = LooseEdges::Ignored;
    EXPECT_EQ(networkFromShape(shape, options).network.curves.size(), 5U);
    options.looseEdges = LooseEdges::Constraint;
    EXPECT_EQ(networkFromShape(shape, options).network.curves.back().role, Role::Constraint);
    options.looseEdges = LooseEdges::Boundary;
    options.edgeRoles = {{6, Role::Ignored}};
    EXPECT_EQ(networkFromShape(shape, options).network.curves.back().role, Role::Ignored);
    options.edgeRoles = {{7, Role::Ignored}};
    EXPECT_THROW(networkFromShape(shape, options), CadError);
}

TEST(ShapeNetwork, EdgesWhoseVerticesCoincideShareTheirPoints)
{
    // As in a sketch: each line has vertices of its own.
    const gp_Pnt a(0, 0, 0);
    const gp_Pnt b(4, 0, 0);
    const gp_Pnt c(4, 3, 0);
    const TopoDS_Shape shape = compound({BRepBuilderAPI_MakeEdge(a, b).Edge(),
                                         BRepBuilderAPI_MakeEdge(b, c).Edge(),
                                         BRepBuilderAPI_MakeEdge(c, a).Edge()});
    const CurveNetwork network = networkFromShape(shape).network;
    EXPECT_EQ(network.points.size(), 3U);
    ASSERT_EQ(network.curves.size(), 3U);
    EXPECT_EQ(network.curves[0].end, network.curves[1].start);
    EXPECT_EQ(network.curves[1].end, network.curves[2].start);
    EXPECT_EQ(network.curves[2].end, network.curves[0].start);
}

TEST(ShapeNetwork, NamesOfEdgesCanBeGiven)
{
    CadOptions options;
    options.name = "Sketch";
    options.edgeNames = {"Inlet", ""};
    const CadInput input = networkFromShape(square(3), options);
    EXPECT_EQ(input.network.curveNames,
              (std::vector<std::string> {"Inlet", "Sketch_Edge2", "Sketch_Edge3", "Sketch_Edge4"}));
    EXPECT_EQ(input.network.operands[0].name, "Sketch");
}

TEST(ShapeNetwork, EllipseIsExact)
{
    const gp_Elips ellipse(gp_Ax2(gp_Pnt(1, 2, 0), gp::DZ(), gp_Dir(1, 1, 0)), 5, 3);
    const CadInput input = networkFromShape(BRepBuilderAPI_MakeEdge(ellipse).Edge());
    EXPECT_NEAR(sweptArea(input.network, input.network.curves[0]), 15 * pi, 1e-10);
    EXPECT_DOUBLE_EQ(input.network.curves[0].geometry->secondDerivativeBound(0, 1), 5.0);
}

TEST(ShapeNetwork, ReversedCurveIsTheSameCurveBackwards)
{
    const gp_Circ curve(gp_Ax2(gp_Pnt(1, 2, 0), gp::DZ()), 3);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(curve, 0.25, 2.0);
    const auto there = networkFromShape(edge).network.curves[0].geometry;
    const CadInput input = networkFromShape(edge.Reversed());
    const auto back = input.network.curves[0].geometry;
    EXPECT_EQ(there->point(there->first()), back->point(back->last()));
    EXPECT_EQ(there->point(there->last()), back->point(back->first()));
    EXPECT_LT(greatestEndGap(input.network), 1e-15);
    const Vec2 d1 = there->derivative(there->first());
    const Vec2 d2 = back->derivative(back->last());
    EXPECT_EQ(d1, -1.0 * d2);
    EXPECT_EQ(there->secondDerivative(there->last()), back->secondDerivative(back->first()));
}

TEST(ShapeNetwork, ReversedSplineIsTheSameCurveBackwards)
{
    const auto wavy = spline(3, {{0, 0, 0}, {1, 4, 0}, {2, -3, 0}, {3, 9, 0}}, {1, 3}, {4, 4});
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(wavy);
    const auto there = networkFromShape(edge).network.curves[0].geometry;
    const CadInput input = networkFromShape(edge.Reversed());
    const auto back = input.network.curves[0].geometry;
    EXPECT_EQ(greatestEndGap(input.network), 0.0);
    for (double t = 1.0; t <= 3.0; t += 0.25) { // exact in binary
        EXPECT_EQ(there->point(t), back->point(4.0 - t));
        EXPECT_EQ(there->derivative(t), -1.0 * back->derivative(4.0 - t));
        EXPECT_EQ(there->secondDerivative(t), back->secondDerivative(4.0 - t));
        const gp_Pnt p = wavy->Value(t);
        EXPECT_EQ(there->point(t), (Vec2 {p.X(), p.Y()}));
    }
}

TEST(ShapeNetwork, SplineIsCutAtItsCorners)
{
    const auto corner = spline(2, {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {3, -1, 0}, {4, 0, 0}},
                               {0, 1, 2}, {3, 2, 3});
    const CadInput input = networkFromShape(BRepBuilderAPI_MakeEdge(corner).Edge());
    ASSERT_EQ(input.network.curves.size(), 2U);
    EXPECT_EQ(input.network.curves[0].end, input.network.curves[1].start);
    EXPECT_EQ(input.network.points[input.network.curves[0].end.index()], (Vec2 {2, 0}));
    EXPECT_EQ(input.network.curves[0].source, input.network.curves[1].source);
    const auto& left = *input.network.curves[0].geometry;
    const auto& right = *input.network.curves[1].geometry;
    EXPECT_GT(cross(left.derivative(left.last()), right.derivative(right.first())), 1.0);

    // The same curve with its direction continuous stays whole.
    const auto smooth = spline(2, {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {3, -2, 0}, {4, 0, 0}},
                               {0, 1, 2}, {3, 2, 3});
    EXPECT_EQ(networkFromShape(BRepBuilderAPI_MakeEdge(smooth).Edge()).network.curves.size(), 1U);
}

TEST(ShapeNetwork, PolylineSplineBecomesStraightCurves)
{
    const auto zigzag = spline(1, {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {3, 0, 0}}, {0, 1, 2, 3},
                               {2, 1, 1, 2});
    const CadInput input = networkFromShape(BRepBuilderAPI_MakeEdge(zigzag).Edge());
    ASSERT_EQ(input.network.curves.size(), 3U);
    for (const NetworkCurve& curve : input.network.curves) {
        EXPECT_EQ(curve.geometry, nullptr);
    }
    EXPECT_EQ(input.network.points.size(), 4U);
}

TEST(ShapeNetwork, PeriodicSplineCloses)
{
    TColgp_Array1OfPnt poles(1, 6);
    TColStd_Array1OfReal knots(1, 7);
    TColStd_Array1OfInteger multiplicities(1, 7);
    for (int i = 1; i <= 6; ++i) {
        poles.SetValue(i, {5 * std::cos(i * pi / 3), 3 * std::sin(i * pi / 3), 0});
    }
    for (int i = 1; i <= 7; ++i) {
        knots.SetValue(i, i - 1);
        multiplicities.SetValue(i, 1);
    }
    const Handle(Geom_BSplineCurve) closed
        = new Geom_BSplineCurve(poles, knots, multiplicities, 3, true);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(closed);
    const CadInput input = networkFromShape(edge);
    ASSERT_EQ(input.network.curves.size(), 1U);
    EXPECT_EQ(input.network.curves[0].start, input.network.curves[0].end);
    EXPECT_LT(greatestEndGap(input.network), 1e-12);
    const Curve& curve = *input.network.curves[0].geometry;
    for (double t = 0.01; t < 6.0; t += 0.13) {
        const gp_Pnt p = closed->Value(t);
        EXPECT_LT(distance(curve.point(t), {p.X(), p.Y()}), 1e-13);
    }
}

TEST(ShapeNetwork, SecondDerivativeBoundHoldsAndIsTight)
{
    const auto wavy = spline(3, {{0, 0, 0}, {1, 4, 0}, {2, -3, 0}, {3, 9, 0}, {4, 0, 0}, {9, 1, 0}},
                             {0, 0.3, 2, 3}, {4, 1, 1, 4});
    for (const bool reversed : {false, true}) {
        TopoDS_Shape edge = BRepBuilderAPI_MakeEdge(wavy).Edge();
        const auto curve
            = networkFromShape(reversed ? edge.Reversed() : edge).network.curves[0].geometry;
        const double width = 0.21;
        for (double a = 0.0; a + width <= 3.0; a += 0.07) {
            const double bound = curve->secondDerivativeBound(a, a + width);
            double seen = 0.0;
            for (int i = 0; i <= 50; ++i) {
                seen = std::max(seen, length(curve->secondDerivative(a + width * i / 50)));
            }
            EXPECT_LE(seen, bound * (1 + 1e-12));
        }
        double whole = 0.0;
        for (int i = 0; i <= 300; ++i) {
            whole = std::max(whole, length(curve->secondDerivative(0.01 * i)));
        }
        EXPECT_LE(curve->secondDerivativeBound(0.0, 3.0), 1.5 * whole);
    }
}

TEST(ShapeNetwork, CurvedFaceIsRefusedWithItsDistance)
{
    try {
        networkFromShape(BRepPrimAPI_MakeSphere(5.0).Face());
        FAIL() << "a sphere was accepted";
    }
    catch (const CadError& error) {
        EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
        const std::string what = error.what();
        EXPECT_NE(what.find("Face1: spherical"), std::string::npos) << what;
        EXPECT_NE(what.find("choose planar faces"), std::string::npos) << what;
    }
}

TEST(ShapeNetwork, FacesOfSeveralPlanesAreRefusedWithEdgesAndDistance)
{
    try {
        networkFromShape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
        FAIL() << "a box was accepted";
    }
    catch (const CadError& error) {
        EXPECT_EQ(error.where().size(), 8U);
        EXPECT_EQ(error.places().size(), 8U);
        EXPECT_NE(std::string(error.what()).find("up to 1 out of the plane of Face1"),
                  std::string::npos) << error.what();
    }
}

TEST(ShapeNetwork, BentLooseEdgesAreRefused)
{
    const TopoDS_Wire bent = polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0.5}, {0, 4, 0}});
    EXPECT_THROW(networkFromShape(bent), CadError);
    const auto twisted = spline(3, {{0, 0, 0}, {1, 4, 0}, {2, -3, 1}, {3, 2, 0}}, {0, 1}, {4, 4});
    EXPECT_THROW(networkFromShape(BRepBuilderAPI_MakeEdge(twisted).Edge()), CadError);
}

TEST(ShapeNetwork, EmptyShapesAreRefused)
{
    EXPECT_THROW(networkFromShape(TopoDS_Shape()), CadError);
    EXPECT_THROW(networkFromShape(compound({})), CadError);
}

TEST(ShapeNetwork, OneStraightEdgeInSpaceHasAPlane)
{
    const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 2, 3), gp_Pnt(4, 4, 9));
    const CadInput input = networkFromShape(line);
    const auto start = input.frame.toSpace(input.network.points[0]);
    EXPECT_NEAR(start[0], 1, 1e-14);
    EXPECT_NEAR(start[1], 2, 1e-14);
    EXPECT_NEAR(start[2], 3, 1e-14);
    EXPECT_NEAR(distance(input.network.points[0], input.network.points[1]), 7.0, 1e-14);
}

TEST(ShapeNetwork, VertexToleranceSetsTheWeld)
{
    TopoDS_Wire wire = square(10);
    TopExp_Explorer vertex(wire, TopAbs_VERTEX);
    BRep_Builder().UpdateVertex(TopoDS::Vertex(vertex.Current()), 1e-4);
    EXPECT_DOUBLE_EQ(networkFromShape(wire).defaultWeld, 20 * 1e-4);
    EXPECT_DOUBLE_EQ(networkFromShape(square(1e4)).defaultWeld, 1e-7 * 1e4 * std::sqrt(2.0));
}
