// SPDX-License-Identifier: MIT
#include "occt/imprint_faces.h"

#include "io/expect_error.h"
#include "occt/read_shape.h"
#include "occt/shape_measures.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include <gtest/gtest.h>

#include <numbers>

namespace tessera
{
namespace
{

using testing::areaOf;
using testing::countOf;

TopoDS_Face polygonAt(double z, const std::vector<Vec2>& corners)
{
    BRepBuilderAPI_MakePolygon polygon;
    for (const Vec2 p : corners) {
        polygon.Add(gp_Pnt(p.x, p.y, z));
    }
    polygon.Close();
    return BRepBuilderAPI_MakeFace(polygon.Wire());
}

TopoDS_Face rectangleAt(double z, double x0, double y0, double x1, double y1)
{
    return polygonAt(z, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

TopoDS_Face diskAt(double z, double x, double y, double r)
{
    const gp_Circ circle(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), r);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle);
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire());
}

struct Imprinted
{
    ImprintInput input;
    ImprintResult result;
    std::vector<std::vector<TopoDS_Face>> faces;
};

Imprinted imprintFaces(const std::vector<ImprintShape>& shapes,
                       const std::optional<Vec3>& direction = {})
{
    Imprinted done;
    done.input = projectShapes(shapes, direction);
    ImprintOptions options;
    options.weld = done.input.defaultWeld;
    options.tolerance = options.weld;
    Execution execution;
    done.result = imprintNetwork(done.input.network, done.input.side, options, execution);
    done.faces = imprintedFaces(done.result, done.input);
    return done;
}

/// Two halves of a plate below; a disk in its middle and the plate around it above.
std::vector<ImprintShape> halvesAndDisk(double height)
{
    const TopoDS_Face disk = diskAt(height, 2.0, 1.0, 0.5);
    BRepBuilderAPI_MakeFace around(rectangleAt(height, 0, 0, 4, 2));
    around.Add(TopoDS::Wire(TopExp_Explorer(disk, TopAbs_WIRE).Current().Reversed()));
    return {{rectangleAt(0, 0, 0, 2, 2), ImprintSide::Source},
            {rectangleAt(0, 2, 0, 4, 2), ImprintSide::Source},
            {disk, ImprintSide::Target},
            {around.Face(), ImprintSide::Target}};
}

TEST(ImprintFaces, ArePutBackOnEachPlaneWithTheirArcs)
{
    const Imprinted done = imprintFaces(halvesAndDisk(5.0));
    EXPECT_EQ(done.result.cells.size(), 4U);
    EXPECT_TRUE(done.result.left.empty());
    const TopoDS_Compound all = imprintedShape(done.result, done.input);
    EXPECT_TRUE(BRepCheck_Analyzer(all).IsValid());
    EXPECT_NEAR(areaOf(all), 16.0, 1e-12);
    // On each plane: 2 edges across the disk's rim and 2 arcs, a middle line in 3 pieces, and the
    // plate's outline of 6 pieces; the circle starts between its crossings, so one arc is cut.
    EXPECT_EQ(countOf(all, TopAbs_FACE), 8U);
    EXPECT_EQ(countOf(all, TopAbs_EDGE), 2U * (3 + 3 + 6));
    for (std::size_t o = 0; o < 4; ++o) {
        ASSERT_EQ(done.faces[o].size(), 2U);
        for (const TopoDS_Face& face : done.faces[o]) {
            EXPECT_TRUE(BRepCheck_Analyzer(face).IsValid());
            const BRepAdaptor_Surface surface(face);
            EXPECT_EQ(surface.GetType(), GeomAbs_Plane);
            EXPECT_EQ(surface.Plane().Location().Z(), o < 2 ? 0.0 : 5.0);
            std::size_t arcs = 0;
            for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
                const BRepAdaptor_Curve curve(TopoDS::Edge(e.Current()));
                arcs += curve.GetType() == GeomAbs_Circle ? 1 : 0;
                EXPECT_EQ(curve.Value(curve.FirstParameter()).Z(), o < 2 ? 0.0 : 5.0);
            }
            EXPECT_GE(arcs, 1U);
        }
    }
    EXPECT_NEAR(areaOf(done.faces[2][0]) + areaOf(done.faces[2][1]), 0.25 * std::numbers::pi,
                1e-12);
}

TEST(ImprintFaces, AlongAnObliqueDirection)
{
    // The target lies where the direction leads: 5 up is 3 to the right.
    std::vector<ImprintShape> shapes = {
        {rectangleAt(0, 0, 0, 2, 2), ImprintSide::Source},
        {rectangleAt(5, 3, 0, 4, 2), ImprintSide::Target},
        {rectangleAt(5, 4, 0, 5, 2), ImprintSide::Target},
    };
    const Imprinted done = imprintFaces(shapes, Vec3 {3.0, 0.0, 5.0});
    EXPECT_TRUE(done.result.left.empty());
    ASSERT_EQ(done.result.cells.size(), 2U);
    for (std::size_t t = 1; t < 3; ++t) {
        ASSERT_EQ(done.faces[t].size(), 1U);
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(done.faces[t][0], properties);
        EXPECT_NEAR(properties.Mass(), 2.0, 1e-12);
        EXPECT_NEAR(properties.CentreOfMass().X(), t == 1 ? 3.5 : 4.5, 1e-12);
        EXPECT_NEAR(properties.CentreOfMass().Z(), 5.0, 1e-12);
    }
}

TEST(ImprintFaces, OfASolidTurnedInSpaceLookAsItsFacesDid)
{
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.3)), 0.7);
    const TopoDS_Shape box = BRepBuilderAPI_Transform(BRepPrimAPI_MakeBox(2, 3, 4).Shape(), turn);
    std::vector<TopoDS_Shape> caps;
    for (TopExp_Explorer f(box, TopAbs_FACE); f.More(); f.Next()) {
        if (std::abs(areaOf(f.Current()) - 6.0) < 1e-9) {
            caps.push_back(f.Current());
        }
    }
    ASSERT_EQ(caps.size(), 2U);
    const Imprinted done =
        imprintFaces({{caps[0], ImprintSide::Source}, {caps[1], ImprintSide::Target}});
    ASSERT_EQ(done.result.cells.size(), 1U);
    EXPECT_TRUE(done.result.left.empty());
    for (std::size_t o = 0; o < 2; ++o) {
        const auto normal = [](const TopoDS_Face& face) {
            gp_Dir z = BRepAdaptor_Surface(face).Plane().Axis().Direction();
            return face.Orientation() == TopAbs_REVERSED ? z.Reversed() : z;
        };
        EXPECT_TRUE(normal(done.faces[o][0]).IsEqual(normal(TopoDS::Face(caps[o])), 1e-9));
    }
}

TEST(ImprintFaces, WhatCannotBeProjectedIsRefusedInWords)
{
    gp_Trsf tilt;
    tilt.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp::DX()), 10.0 * std::numbers::pi / 180.0);
    const ImprintShape flat {rectangleAt(0, 0, 0, 2, 2), ImprintSide::Source};
    const ImprintShape tilted {
        BRepBuilderAPI_Transform(rectangleAt(0, 0, 0, 2, 2), tilt).Shape(), ImprintSide::Target};
    const auto project = [](const std::vector<ImprintShape>& shapes,
                            const std::optional<Vec3>& direction = {}) {
        return [=] { projectShapes(shapes, direction); };
    };
    testing::expectError(ErrorKind::InvalidInput, "tilted by 10 degrees",
                         project({flat, tilted}));
    testing::expectError(ErrorKind::InvalidOption, "at 0 degrees to their plane",
                         project({flat, flat}, Vec3 {1.0, 1.0, 0.0}));
    testing::expectError(ErrorKind::InvalidOption, "no length",
                         project({flat, flat}, Vec3 {0.0, 0.0, 0.0}));
    const ImprintShape round {BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape(), ImprintSide::Target};
    testing::expectError(ErrorKind::InvalidInput, "cylindrical", project({flat, round}));
    testing::expectError(ErrorKind::InvalidInput, "empty", project({{}}));
    try {
        projectShapes(std::vector {flat, tilted}, {});
    }
    catch (const CadError& error) {
        EXPECT_EQ(error.shape(), 1U);
        EXPECT_FALSE(error.where().empty());
    }
}

TEST(ImprintFaces, AreWrittenAsBrepAndStep)
{
    const Imprinted done = imprintFaces(halvesAndDisk(3.0));
    const testing::TemporaryFolder folder;
    for (const std::string name : {"out.brep", "out.step"}) {
        writeImprint(done.result, done.input, folder / name);
        const TopoDS_Shape again = shapeFromFile(folder / name);
        EXPECT_EQ(countOf(again, TopAbs_FACE), 8U);
        EXPECT_NEAR(areaOf(again), 16.0, 1e-9);
    }
}

} // namespace
} // namespace tessera
