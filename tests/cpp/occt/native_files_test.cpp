// SPDX-License-Identifier: MIT
// Every planar face of the CAD files in the corpora, against OpenCASCADE's own area.
#include "occt/read_cad.h"
#include "occt/rehearse.h"
#include "occt/shape_network.h"

#include "corpora_folder.h"
#include "network_measures.h"

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

using namespace tessera;
using namespace tessera::test;

namespace
{

TopTools_IndexedMapOfShape facesOf(const std::filesystem::path& path)
{
    TopoDS_Shape shape;
    BRepTools::Read(shape, path.c_str(), BRep_Builder());
    TopTools_IndexedMapOfShape faces;
    if (!shape.IsNull()) {
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
    }
    return faces;
}

std::string messageOf(const std::filesystem::path& path)
{
    try {
        readCad(path);
    }
    catch (const Error& error) {
        return error.kind() == ErrorKind::Unreadable ? std::string("unreadable: ") + error.what()
                                                     : error.what();
    }
    return "";
}

std::filesystem::path scratch(const std::string& name, const std::string& text)
{
    const auto path = std::filesystem::path(TESSERA_BINARY_DIR) / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

std::string textOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// How far the area may differ because edges and their images in the plane differ by their
/// tolerance.
double areaTolerance(const TopoDS_Face& face)
{
    double sum = 0.0;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        GProp_GProps length;
        BRepGProp::LinearProperties(e.Current(), length);
        sum += length.Mass() * BRep_Tool::Tolerance(TopoDS::Edge(e.Current()));
    }
    return sum;
}

constexpr const char* kOneEdgeBrep = R"(DBRep_DrawableShape

CASCADE Topology V1, (c) Matra-Datavision
Locations 0
Curve2ds 0
Curves 1
1 0 0 0 1 0 0 
Polygon3D 0
PolygonOnTriangulations 0
Surfaces 0
Triangulations 0

TShapes 3
Ve
1e-07
0 0 0
0 0

0101101
*
Ve
1e-07
5 0 0
0 0

0101101
*
Ed
 1e-07 1 1 0
1  1 0 0 5
0

0101000
+3 0 -2 0 *

+1 0 
)";

} // namespace

TEST(NativeFiles, AreaOfEveryPlanarFaceIsOpenCascades)
{
    TESSERA_NEEDS_CORPORA();
    const std::filesystem::path folder = corpora() / "cad/native";
    int planar = 0;
    int refused = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".brep") {
            continue;
        }
        const TopTools_IndexedMapOfShape faces = facesOf(entry.path());
        for (int i = 1; i <= faces.Extent(); ++i) {
            const TopoDS_Face face = TopoDS::Face(faces(i));
            const bool isPlane
                = BRep_Tool::Surface(face)->IsKind(STANDARD_TYPE(Geom_Plane));
            SCOPED_TRACE(entry.path().filename().string() + " face " + std::to_string(i));
            if (!isPlane) {
                try {
                    networkFromShape(face);
                }
                catch (const CadError&) {
                    ++refused;
                }
                continue;
            }
            ++planar;
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(face, properties, 1e-10);
            const CadInput input = networkFromShape(face);
            EXPECT_TRUE(boundaryIsClosed(input.network));
            EXPECT_NEAR(enclosedArea(input.network), std::abs(properties.Mass()),
                        1e-7 * std::abs(properties.Mass()) + areaTolerance(face));
            EXPECT_LE(greatestEndGap(input.network), input.defaultWeld);
        }
    }
    EXPECT_GT(planar, 400);
    EXPECT_GT(refused, 200);
}

TEST(NativeFiles, SolidsAreRefusedInWordsAndStepIsRead)
{
    TESSERA_NEEDS_CORPORA();
    const std::filesystem::path folder = corpora() / "cad/native";
    EXPECT_NE(messageOf(folder / "FreeCAD_as1-ac-214.stp").find("cylindrical"), std::string::npos);
    EXPECT_NE(messageOf(folder / "OCCT_wedge_ok.brep").find("out of the plane of Face1"),
              std::string::npos);
    EXPECT_EQ(messageOf(folder / "OCCT_edge.brep").rfind("unreadable", 0), std::string::npos);
}

TEST(ReadCad, BrepOfOneEdge)
{
    const CadInput input = readCad(scratch("one_edge.brep", kOneEdgeBrep));
    ASSERT_EQ(input.network.curves.size(), 1U);
    EXPECT_EQ(input.network.points[1], (Vec2 {5, 0}));
}

TEST(ReadCad, SeveralShapesShareOnePlane)
{
    std::string raised = kOneEdgeBrep;
    raised.replace(raised.find("\n0 0 0\n"), 7, "\n0 3 4\n").replace(raised.find("\n5 0 0\n"), 7,
                                                                        "\n5 3 4\n");
    raised.replace(raised.find("1 0 0 0 1 0 0"), 13, "1 0 3 4 1 0 0");
    const BrepText low {kOneEdgeBrep, {}, "low"};
    const BrepText high {raised, {}, "high"};
    const auto inputs = readBrepTexts(std::vector {low, high});
    ASSERT_EQ(inputs.size(), 2U);
    EXPECT_EQ(inputs[0].frame, inputs[1].frame);
    EXPECT_NEAR(distance(inputs[0].network.points[0], inputs[1].network.points[0]), 5.0, 1e-14);

    BrepText flat = low;
    flat.options.plane = PlaneFrame {};
    try {
        readBrepTexts(std::vector {flat, high});
        FAIL() << "an edge above the given plane was accepted";
    }
    catch (const CadError& error) {
        EXPECT_EQ(error.shape(), 1U);
        ASSERT_EQ(error.where().size(), 1U);
        EXPECT_EQ(error.where()[0].edge, 1U);
        EXPECT_EQ(error.where()[0].point, (std::array<double, 3> {2.5, 3.0, 4.0}));
    }
}

TEST(ReadCad, MissingForeignAndTruncatedFilesAreUnreadable)
{
    EXPECT_EQ(messageOf("/nowhere/at/all.brep").rfind("unreadable", 0), 0U);
    EXPECT_EQ(messageOf(TESSERA_BINARY_DIR).rfind("unreadable", 0), 0U);
    EXPECT_EQ(messageOf(scratch("words.brep", "hello\n")).rfind("unreadable", 0), 0U);
    EXPECT_EQ(messageOf(scratch("words.step", "hello\n")).rfind("unreadable", 0), 0U);
    EXPECT_EQ(messageOf(scratch("empty.step", "")).rfind("unreadable", 0), 0U);
    const std::string text = kOneEdgeBrep;
    for (std::size_t length = 0; length + 4 < text.size(); ++length) {
        const auto path = scratch("truncated.brep", text.substr(0, length));
        ASSERT_EQ(messageOf(path).rfind("unreadable", 0), 0U) << length;
    }
}

TEST(ReadCad, TruncatedCorpusFilesAreUnreadable)
{
    TESSERA_NEEDS_CORPORA();
    const std::filesystem::path folder = corpora() / "cad/native";
    for (const char* name : {"FreeCAD_cylinder4.brep", "OCCT_screw.step"}) {
        const std::string text = textOf(folder / name);
        ASSERT_GT(text.size(), 1000U);
        for (int i = 0; i < 200; ++i) {
            const auto path = scratch(std::string("cut_") + name,
                                      text.substr(0, (text.size() - 40) * i / 200));
            ASSERT_EQ(messageOf(path).rfind("unreadable", 0), 0U) << name << " part " << i;
        }
    }
}

TEST(ReadCad, DamageThatCrashesOpenCascadeIsReported)
{
    std::string text = kOneEdgeBrep;
    // A trimmed curve without the curve that it trims.
    text.replace(text.find("1 0 0 0 1 0 0"), 13, "8 0 5\n99 0 0 0");
    EXPECT_EQ(messageOf(scratch("damaged.brep", text)).rfind("unreadable", 0), 0U);
}

TEST(Rehearse, TellsCrashesFromExceptions)
{
    EXPECT_TRUE(comesBack([] {}, 0));
    EXPECT_TRUE(comesBack([] { throw std::runtime_error("reported to the caller"); }, 0));
    EXPECT_FALSE(comesBack([] { std::abort(); }, 0));
}
