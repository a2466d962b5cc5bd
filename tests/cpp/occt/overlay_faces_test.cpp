// SPDX-License-Identifier: MIT
#include "occt/overlay_faces.h"

#include "curve/arc.h"
#include "io/expect_error.h"
#include "occt/edge_curve.h"
#include "occt/read_cad.h"
#include "occt/shape_measures.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

using testing::areaOf;
using testing::countOf;

struct Circle
{
    Vec2 center;
    double radius;
};

OverlayResult overlayCircles(const std::vector<Circle>& circles, BooleanOperation operation,
                             OverlayForm form = OverlayForm::Triangles)
{
    CurveNetwork network;
    network.operands.resize(circles.size());
    for (std::size_t o = 0; o < circles.size(); ++o) {
        const auto [center, r] = circles[o];
        const auto arc = std::make_shared<EllipseArc>(center, Vec2 {r, 0.0}, Vec2 {0.0, r}, 0.0,
                                                      2.0 * std::numbers::pi);
        const PointId start = network.addPoint(arc->point(0.0));
        network.curves.push_back({arc, start, start, OperandId(o)});
    }
    OverlayOptions options;
    options.operation = operation;
    options.form = form;
    Execution execution;
    return overlayNetwork(std::move(network), options, execution);
}

bool isValid(const TopoDS_Shape& shape)
{
    return BRepCheck_Analyzer(shape).IsValid();
}

TEST(OverlayFaces, AnArcStaysAnArcAndNeighborsShareTheirEdges)
{
    const auto result =
        overlayCircles({{{0.0, 0.0}, 1.0}, {{1.0, 0.0}, 1.0}}, BooleanOperation::Cells);
    const TopoDS_Compound faces = facesOf(result, {});
    EXPECT_TRUE(isValid(faces));
    EXPECT_EQ(countOf(faces, TopAbs_FACE), 3U);
    // Each circle is cut at two crossings and its start; the starts lie at (1, 0) and (2, 0).
    EXPECT_EQ(countOf(faces, TopAbs_EDGE), 6U);
    EXPECT_EQ(countOf(faces, TopAbs_VERTEX), 4U);
    for (TopExp_Explorer edge(faces, TopAbs_EDGE); edge.More(); edge.Next()) {
        EXPECT_EQ(BRepAdaptor_Curve(TopoDS::Edge(edge.Current())).GetType(), GeomAbs_Circle);
    }
    const double lens = 2.0 * std::numbers::pi / 3.0 - std::sqrt(3.0) / 2.0;
    EXPECT_NEAR(areaOf(faces), 2.0 * std::numbers::pi - lens, 1e-12);
    for (TopExp_Explorer face(faces, TopAbs_FACE); face.More(); face.Next()) {
        const double area = areaOf(face.Current());
        EXPECT_NEAR(area, area < 1.5 ? lens : std::numbers::pi - lens, 1e-12);
    }
}

TEST(OverlayFaces, HolesAndAPlaneInSpace)
{
    const auto result =
        overlayCircles({{{0.0, 0.0}, 2.0}, {{0.5, 0.0}, 1.0}}, BooleanOperation::Difference);
    PlaneFrame frame;
    frame.origin = {1.0, 2.0, 3.0};
    frame.x = {0.0, 1.0, 0.0};
    frame.y = {0.0, 0.0, 1.0};
    frame.z = {1.0, 0.0, 0.0};
    const TopoDS_Compound faces = facesOf(result, frame);
    EXPECT_TRUE(isValid(faces));
    EXPECT_EQ(countOf(faces, TopAbs_FACE), 1U);
    EXPECT_EQ(countOf(faces, TopAbs_WIRE), 2U);
    EXPECT_NEAR(areaOf(faces), 3.0 * std::numbers::pi, 1e-12);
    for (TopExp_Explorer vertex(faces, TopAbs_VERTEX); vertex.More(); vertex.Next()) {
        EXPECT_EQ(BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())).X(), 1.0);
    }
}

TEST(OverlayFaces, ManyOverlappingCirclesCoverWhatTheirAnglesSay)
{
    // A row: each circle overlaps the next one in the same lens.
    std::vector<Circle> circles;
    for (int i = 0; i < 40; ++i) {
        circles.push_back({{1.5 * i, 0.0}, 1.0});
    }
    const TopoDS_Compound faces = facesOf(overlayCircles(circles, BooleanOperation::Cells), {});
    EXPECT_TRUE(isValid(faces));
    EXPECT_EQ(countOf(faces, TopAbs_FACE), 79U);
    const double lens = 2.0 * std::acos(0.75) - 0.75 * std::sqrt(4.0 - 2.25);
    EXPECT_NEAR(areaOf(faces), 40.0 * std::numbers::pi - 39.0 * lens, 1e-9);
}

/// Form Faces: coarse polygons with the same topology, areas of the curves themselves.
TEST(OverlayFaces, CoarsePolygonsGiveTheSameFacesAndTrueAreas)
{
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Circle> circles {{{0.5, 0.5}, 0.25}, {{0.5, 0.5}, 0.25}}; // one twice
    circles.push_back({{0.5, 0.5}, 0.25001});                             // one almost
    for (int i = 0; i < 30; ++i) {
        circles.push_back({{unit(random), unit(random)}, 0.02 + 0.2 * unit(random)});
    }
    for (const BooleanOperation operation :
         {BooleanOperation::Cells, BooleanOperation::Union, BooleanOperation::Difference,
          BooleanOperation::SymmetricDifference}) {
        const OverlayResult fine = overlayCircles(circles, operation);
        const OverlayResult coarse = overlayCircles(circles, operation, OverlayForm::Faces);
        EXPECT_LT(coarse.pslg.points.size(), fine.pslg.points.size() / 2);
        const TopoDS_Compound faces = facesOf(coarse, {});
        EXPECT_TRUE(isValid(faces));
        ASSERT_EQ(countOf(faces, TopAbs_FACE), coarse.parts.parts.size());
        EXPECT_EQ(countOf(faces, TopAbs_FACE), fine.parts.parts.size());
        EXPECT_EQ(countOf(faces, TopAbs_EDGE), countOf(facesOf(fine, {}), TopAbs_EDGE));
        EXPECT_NEAR(areaOf(faces), coarse.report.area, 1e-12);
        EXPECT_NEAR(areaOf(facesOf(fine, {})), coarse.report.area, 1e-12);
        std::size_t part = 0;
        for (TopExp_Explorer face(faces, TopAbs_FACE); face.More(); face.Next(), ++part) {
            EXPECT_NEAR(areaOf(face.Current()), coarse.parts.parts[part].area, 1e-12);
        }
    }
    const OverlayResult two = overlayCircles({{{0.0, 0.0}, 1.0}, {{1.0, 0.0}, 1.0}},
                                             BooleanOperation::Union, OverlayForm::Faces);
    const double lens = 2.0 * std::numbers::pi / 3.0 - std::sqrt(3.0) / 2.0;
    EXPECT_NEAR(two.report.theta->o, lens, 1e-14);
    EXPECT_NEAR(two.report.theta->t, std::numbers::pi - lens, 1e-14);
}

/// A closed B-spline as FreeCAD draws it, whose stored range may differ from its period by rounding.
TopoDS_Face closedSpline()
{
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 5);
    const double xy[5][2] = {{-2, -2}, {2, -2}, {2.5, 2}, {0, 0.5}, {-2, 2}};
    for (int i = 0; i < 5; ++i) {
        points->SetValue(i + 1, gp_Pnt(xy[i][0], xy[i][1], 0.0));
    }
    GeomAPI_Interpolate interpolate(points, Standard_True, 1e-9);
    interpolate.Perform();
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(interpolate.Curve());
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire(), Standard_True);
}

TEST(OverlayFaces, AClosedSplineKeepsItsShape)
{
    const TopoDS_Face drawn = closedSpline();
    TopExp_Explorer edges(drawn, TopAbs_EDGE);
    EdgeCurve curve = curveOf(TopoDS::Edge(edges.Current()));
    for (const double rounding : {0.0, 4e-15, -4e-15}) {
        EdgeCurve range = curve;
        range.last += rounding;
        const auto pieces = smoothPieces(range);
        ASSERT_EQ(pieces.size(), 1U);
        for (int i = 0; i <= 20; ++i) {
            const double t = curve.first + (curve.last - curve.first) * i / 20.0;
            EXPECT_LT(pieces[0].curve->Value(t).Distance(curve.curve->Value(t)), 1e-12);
        }
    }
    const testing::TemporaryFolder folder;
    const std::string path = (folder / "spline.brep").string();
    ASSERT_TRUE(BRepTools::Write(drawn, path.c_str()));
    CadInput input = readCad(path, {});
    OverlayOptions options;
    options.weld = input.defaultWeld;
    Execution execution;
    const OverlayResult result = overlayNetwork(std::move(input.network), options, execution);
    const TopoDS_Compound faces = facesOf(result, input.frame);
    EXPECT_TRUE(isValid(faces));
    EXPECT_NEAR(areaOf(faces), 21.343218, 0.02); // OpenCASCADE's integral is no better
    EXPECT_NEAR(result.report.area, 21.343218, 2e-3);
}

TEST(OverlayFaces, AreWrittenAsBrepAndStep)
{
    const auto result =
        overlayCircles({{{0.0, 0.0}, 1.0}, {{1.0, 0.0}, 1.0}}, BooleanOperation::Union);
    const testing::TemporaryFolder folder;
    for (const std::string name : {"union.brep", "union.step"}) {
        writeFaces(result, {}, folder / name);
        const CadInput again = readCad((folder / name).string(), {});
        EXPECT_EQ(again.network.operands.size(), 1U);
        EXPECT_EQ(again.network.curves.size(), 3U); // one circle is cut at its start
    }
    EXPECT_THROW(writeFaces(result, {}, folder / "no" / "union.brep"), Error);
}

} // namespace
} // namespace tessera
