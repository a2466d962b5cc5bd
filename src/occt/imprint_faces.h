// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/imprint.h"
#include "occt/cad_input.h"

#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

using Vec3 = std::array<double, 3>;

/// Planar faces, or closed wires, on one side of an imprint.
struct ImprintShape
{
    TopoDS_Shape shape;
    ImprintSide side = ImprintSide::Source;
    CadOptions options {}; ///< the plane is chosen by projectShapes()
};

/// Where an operand of the projected network comes from.
struct ImprintOrigin
{
    std::size_t shape = 0;     ///< index among the shapes
    std::uint32_t face = 0;    ///< number of the face in it, from 1; 0: of its loose edges
    Vec3 lift {};              ///< leads from the common plane to its own, along the direction
    bool upsideDown = false;   ///< its face looks against the frame's z axis
};

/// All sources and targets projected on the plane of the first source.
struct ImprintInput
{
    CurveNetwork network;
    std::vector<ImprintSide> side;      ///< by operand
    std::vector<ImprintOrigin> origins; ///< by operand
    PlaneFrame frame;                   ///< the common plane
    double defaultWeld = 0.0;           ///< the greatest of CadInput::defaultWeld
};

/// The direction of an imprint at length 1, for faces with that unit normal. Throws
/// Error(InvalidOption) for one within their planes or without length.
Vec3 unitDirection(Vec3 direction, const Vec3& normal);

/// Each face becomes an operand, of a shape without faces its loose edges together; loose edges
/// beside faces are left out. direction: of any length, none: the common normal of the faces.
/// Throws CadError(InvalidInput), shape() and face() say for which: faces that are not planar (with the
/// distance) or not parallel to the first one (with the angle), and as networkFromShape();
/// as unitDirection().
ImprintInput projectShapes(std::span<const ImprintShape> shapes,
                           const std::optional<Vec3>& direction);

/// By operand, the faces of its cells on its own plane, in the order of ImprintResult::cellsOfSource
/// and cellsOfTarget, bounded by the original curves trimmed. Faces on one plane share edges and
/// vertices. They look where the operand's face did.
std::vector<std::vector<TopoDS_Face>> imprintedFaces(const ImprintResult& result,
                                                     const ImprintInput& input);

/// One compound of two: of the sources and of the targets; in each a compound for each operand.
TopoDS_Compound imprintedShape(const ImprintResult& result, const ImprintInput& input);

/// Writes that compound as .brep or .step, by extension. The file appears whole or not at all.
/// Throws Error(Unwritable).
void writeImprint(const ImprintResult& result, const ImprintInput& input,
                  const std::filesystem::path& path);

} // namespace tessera
