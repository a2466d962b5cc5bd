// SPDX-License-Identifier: MIT
//
// Projecting along a direction moves every plane as a whole, so curves keep their shape: a face is
// moved into the plane of the first source, and the cells of the overlay are moved back, as located
// copies of the same faces. Whatever cells share on the common plane they share on each plane.
#include "occt/imprint_faces.h"

#include "io/append_network.h"
#include "occt/overlay_faces.h"
#include "occt/shape_network.h"
#include "occt/shape_plane.h"

#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace tessera
{

namespace
{

constexpr double kPerDegree = std::numbers::pi / 180.0;
constexpr double kFlattest = 1e-4; ///< sine of the smallest angle between direction and planes

double dotOf(const Vec3& a, const Vec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 crossOf(const Vec3& a, const Vec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double lengthOf(const Vec3& a)
{
    return std::hypot(a[0], a[1], a[2]);
}

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

TopLoc_Location shiftBy(const Vec3& v, double factor)
{
    gp_Trsf translation;
    translation.SetTranslation(gp_Vec(factor * v[0], factor * v[1], factor * v[2]));
    return translation;
}

bool isNull(const Vec3& v)
{
    return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
}

/// A face of a shape, or its loose edges.
struct Unit
{
    TopoDS_Shape shape;
    std::uint32_t face;
};

std::vector<Unit> unitsOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::vector<Unit> units;
    for (int i = 1; i <= faces.Extent(); ++i) {
        units.push_back({faces(i), static_cast<std::uint32_t>(i)});
    }
    if (units.empty()) {
        units.push_back({shape, 0});
    }
    return units;
}

class Projector
{
public:
    Projector(std::span<const ImprintShape> shapes, const std::optional<Vec3>& direction)
        : shapes_(shapes)
        , given_(direction)
    {}

    ImprintInput run()
    {
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            try {
                addShape(i);
            }
            catch (CadError& error) {
                error.setShape(i);
                throw;
            }
        }
        return std::move(input_);
    }

private:
    void addShape(std::size_t index)
    {
        const ImprintShape& given = shapes_[index];
        if (given.shape.IsNull()) {
            throw CadError(ErrorKind::InvalidInput, "The shape is empty; choose planar faces.");
        }
        const std::vector<Unit> units = unitsOf(given.shape);
        for (const Unit& unit : units) {
            CadOptions options = given.options;
            if (units.size() > 1) {
                options.name += (options.name.empty() ? "Face" : "_Face")
                    + std::to_string(unit.face);
            }
            try {
                addUnit(index, unit, std::move(options));
            }
            catch (CadError& error) {
                error.setFace(unit.face);
                throw;
            }
        }
    }

    void addUnit(std::size_t index, const Unit& unit, CadOptions options)
    {
        const PlaneFrame plane = planeOfShapes(std::span(&unit.shape, 1));
        if (input_.origins.empty()) {
            input_.frame = plane;
            direction_ = unitDirection(given_.value_or(input_.frame.z), input_.frame.z);
        }
        ImprintOrigin origin;
        origin.shape = index;
        origin.face = unit.face;
        const Vec3 offset {plane.origin[0] - input_.frame.origin[0],
                           plane.origin[1] - input_.frame.origin[1],
                           plane.origin[2] - input_.frame.origin[2]};
        const double height = dotOf(offset, input_.frame.z) / dotOf(direction_, input_.frame.z);
        if (height != 0.0) {
            origin.lift = {height * direction_[0], height * direction_[1], height * direction_[2]};
        }
        options.plane = input_.frame;
        const TopoDS_Shape moved =
            isNull(origin.lift) ? unit.shape : unit.shape.Moved(shiftBy(origin.lift, -1.0));
        CadInput projected = project(moved, options, plane, unit);
        if (unit.face != 0) {
            origin.upsideDown = isUpsideDown(TopoDS::Face(unit.shape), projected.defaultWeld);
        }
        input_.defaultWeld = std::max(input_.defaultWeld, projected.defaultWeld);
        const std::size_t operands = projected.network.operands.size();
        input_.side.insert(input_.side.end(), operands, shapes_[index].side);
        input_.origins.insert(input_.origins.end(), operands, origin);
        appendNetwork(input_.network, std::move(projected.network));
    }

    /// What leaves the common plane is tilted, and the angle says more than the distance.
    CadInput project(const TopoDS_Shape& moved, const CadOptions& options, const PlaneFrame& plane,
                     const Unit& unit) const
    {
        try {
            return networkFromShape(moved, options);
        }
        catch (const CadError& error) {
            const double angle = std::atan2(lengthOf(crossOf(plane.z, input_.frame.z)),
                                            std::abs(dotOf(plane.z, input_.frame.z)));
            if (error.kind() != ErrorKind::InvalidInput || !(angle > 1e-9)) {
                throw;
            }
            const std::string name = options.name.empty()
                ? unit.face == 0 ? "The shape" : "Face" + std::to_string(unit.face)
                : options.name;
            throw CadError(ErrorKind::InvalidInput,
                           name + " is tilted by " + number(angle / kPerDegree)
                               + " degrees against the first source; choose parallel faces.",
                           error.where());
        }
    }

    bool isUpsideDown(const TopoDS_Face& face, double tolerance) const
    {
        const gp_Dir normal = *planeNormal(face, tolerance);
        const Vec3& z = input_.frame.z;
        const bool down = normal.X() * z[0] + normal.Y() * z[1] + normal.Z() * z[2] < 0.0;
        return down != (face.Orientation() == TopAbs_REVERSED);
    }

    std::span<const ImprintShape> shapes_;
    std::optional<Vec3> given_;
    Vec3 direction_ {};
    ImprintInput input_;
};

} // namespace

Vec3 unitDirection(Vec3 direction, const Vec3& normal)
{
    const double length = lengthOf(direction);
    if (!(length > 0.0) || !std::isfinite(length)) {
        throw Error(ErrorKind::InvalidOption,
                    "The direction has no length; give three numbers that are not all 0.");
    }
    for (double& x : direction) {
        x /= length;
    }
    const double sine = std::abs(dotOf(direction, normal));
    if (sine < kFlattest) {
        throw Error(ErrorKind::InvalidOption,
                    "The direction runs along the faces, at "
                        + number(std::asin(sine) / kPerDegree)
                        + " degrees to their plane; give one that leads away from them.");
    }
    return direction;
}

ImprintInput projectShapes(std::span<const ImprintShape> shapes,
                           const std::optional<Vec3>& direction)
{
    try {
        return Projector(shapes, direction).run();
    }
    catch (const Standard_Failure& failure) {
        throw CadError(ErrorKind::InvalidInput,
                       std::string("OpenCASCADE cannot use the shape (")
                           + failure.GetMessageString() + "); check and repair it.");
    }
}

std::vector<std::vector<TopoDS_Face>> imprintedFaces(const ImprintResult& result,
                                                     const ImprintInput& input)
{
    std::vector<TopoDS_Face> cells;
    const TopoDS_Compound compound = facesOf(result.overlay, input.frame);
    for (TopoDS_Iterator i(compound); i.More(); i.Next()) {
        cells.push_back(TopoDS::Face(i.Value()));
    }
    std::vector<std::vector<TopoDS_Face>> faces;
    std::size_t next[2] = {};
    // One location for each plane, so that faces on it share what they are bounded by.
    std::vector<std::pair<Vec3, TopLoc_Location>> planes;
    for (std::size_t o = 0; o < input.origins.size(); ++o) {
        const ImprintOrigin& origin = input.origins[o];
        const bool source = input.side[o] == ImprintSide::Source;
        const std::size_t number = next[source ? 0 : 1]++;
        const auto& own = source ? result.cellsOfSource[number] : result.cellsOfTarget[number];
        auto plane = planes.begin();
        while (plane != planes.end()
               && lengthOf({plane->first[0] - origin.lift[0], plane->first[1] - origin.lift[1],
                            plane->first[2] - origin.lift[2]})
                   > input.defaultWeld) {
            ++plane;
        }
        if (plane == planes.end()) {
            plane = planes.insert(plane, {origin.lift, isNull(origin.lift)
                                                           ? TopLoc_Location()
                                                           : shiftBy(origin.lift, 1.0)});
        }
        faces.emplace_back();
        for (const std::uint32_t cell : own) {
            TopoDS_Shape face = cells[cell].Moved(plane->second);
            if (origin.upsideDown) {
                face.Reverse();
            }
            faces.back().push_back(TopoDS::Face(face));
        }
    }
    return faces;
}

TopoDS_Compound imprintedShape(const ImprintResult& result, const ImprintInput& input)
{
    const BRep_Builder builder;
    TopoDS_Compound sides[2];
    builder.MakeCompound(sides[0]);
    builder.MakeCompound(sides[1]);
    const auto faces = imprintedFaces(result, input);
    for (std::size_t o = 0; o < faces.size(); ++o) {
        TopoDS_Compound own;
        builder.MakeCompound(own);
        for (const TopoDS_Face& face : faces[o]) {
            builder.Add(own, face);
        }
        builder.Add(sides[input.side[o] == ImprintSide::Source ? 0 : 1], own);
    }
    TopoDS_Compound all;
    builder.MakeCompound(all);
    builder.Add(all, sides[0]);
    builder.Add(all, sides[1]);
    return all;
}

void writeImprint(const ImprintResult& result, const ImprintInput& input,
                  const std::filesystem::path& path)
{
    writeShape(imprintedShape(result, input), path);
}

} // namespace tessera
