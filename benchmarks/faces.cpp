// SPDX-License-Identifier: MIT

// Overlapping planar faces in memory to a conforming compound of faces in memory, against
// OpenCASCADE's General Fuse, which is what Part's generalFuse calls. Same faces, same process,
// process CPU time.
//
//   200 circles          all cells of 200 circles that overlap at random
//   200 circles, apart   smaller ones, with an eighth of the crossings
//
// Afterwards the last results are compared: as many faces, the same areas, and ours are valid by
// BRepCheck_Analyzer; otherwise the status is 1.

#include "section.h"

#include "imprint/overlay.h"
#include "occt/overlay_faces.h"
#include "occt/shape_network.h"

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Version.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace tessera;
using bench::Result;
using bench::Section;

/// Faces and, once they have run, what became of them.
struct Input
{
    std::string name;
    TopTools_ListOfShape faces;
    TopoDS_Shape cells;
    TopoDS_Shape fused;
};

void fillWithCircles(Input& input, std::size_t count, double low, double high)
{
    std::mt19937_64 random(33);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (std::size_t i = 0; i < count; ++i) {
        const double radius = low + (high - low) * unit(random);
        const gp_Pnt center(unit(random), unit(random), 0.0);
        const gp_Circ circle(gp_Ax2(center, gp_Dir(0.0, 0.0, 1.0)), radius);
        BRepBuilderAPI_MakeEdge edge(circle);
        BRepBuilderAPI_MakeWire wire(edge);
        input.faces.Append(BRepBuilderAPI_MakeFace(wire).Shape());
    }
}

TopoDS_Shape cellsOf(const TopTools_ListOfShape& faces)
{
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const TopoDS_Shape& face : faces) {
        builder.Add(all, face);
    }
    CadInput input = networkFromShape(all);
    OverlayOptions options;
    options.operation = BooleanOperation::Cells;
    options.weld = input.defaultWeld;
    options.form = OverlayForm::Faces;
    Execution execution;
    return facesOf(overlayNetwork(std::move(input.network), options, execution), input.frame);
}

TopoDS_Shape fused(const TopTools_ListOfShape& faces)
{
    BRepAlgoAPI_BuilderAlgo fuse;
    fuse.SetArguments(faces);
    fuse.SetNonDestructive(Standard_True);
    fuse.Build();
    return fuse.Shape();
}

std::vector<double> areasOf(const TopoDS_Shape& shape)
{
    std::vector<double> areas;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face.Current(), properties);
        areas.push_back(properties.Mass());
    }
    std::sort(areas.begin(), areas.end());
    return areas;
}

/// The greatest difference, of the largest area.
double greatestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double greatest = a.size() == b.size() ? 0.0 : 1.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        greatest = std::max(greatest, std::abs(a[i] - b[i]) / a.back());
    }
    return greatest;
}

bool agree(const Input& input)
{
    if (input.cells.IsNull() || input.fused.IsNull()) {
        return true;
    }
    const std::vector<double> areas = areasOf(input.cells);
    const double difference = greatestDifference(areas, areasOf(input.fused));
    const bool valid = BRepCheck_Analyzer(input.cells).IsValid();
    std::fprintf(stderr, "%s: %zu faces, %s, areas differ by at most %.1e of the largest\n",
                 input.name.c_str(), areas.size(), valid ? "valid" : "not valid", difference);
    return valid && difference < 1e-9;
}

void add(Section& section, Input& input, double target)
{
    section.add(input.name, "Tessera", [&input](Result& out) {
        input.cells = cellsOf(input.faces);
        out.columns["faces"] = input.cells.NbChildren();
    });
    section.add(input.name, "General Fuse", [&input](Result& out) {
        input.fused = fused(input.faces);
        out.columns["faces"] = input.fused.NbChildren();
    }, 1);
    section.expect(input.name, {"General Fuse", target, 0.0});
}

} // namespace

int main(int argc, char** argv)
{
    Input many {"200 circles", {}, {}, {}};
    Input few {"200 circles, apart", {}, {}, {}};
    fillWithCircles(many, 200, 0.07, 0.14);
    fillWithCircles(few, 200, 0.02, 0.05);
    Section section("Overlapping faces to conforming faces", "OpenCASCADE " OCC_VERSION_STRING_EXT);
    section.note("Each of *200 circles* crosses some twenty-three others, of *200 circles, apart* "
                 "three. All faces' areas are compared with those of General Fuse and checked by "
                 "`BRepCheck_Analyzer`.");
    add(section, many, 0.01);
    add(section, few, 0.0);
    const int status = section.run(argc, argv);
    return status != 0 || (agree(many) && agree(few)) ? status : 1;
}
