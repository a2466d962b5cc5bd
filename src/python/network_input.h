// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "occt/cad_input.h"
#include "python/python_error.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tessera::python
{

using Coordinates
    = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Indices
    = pybind11::array_t<std::int64_t, pybind11::array::c_style | pybind11::array::forcecast>;
/// (number of the edge or segment, role).
using Roles = std::vector<std::pair<std::uint32_t, Role>>;

/// One shape as Python gives it.
struct Shape
{
    std::string brep; ///< text of a .brep file
    std::string name;
    std::vector<std::string> edgeNames;
    std::vector<std::string> vertexNames;
    std::vector<std::string> elements; ///< what each edge is called to the user; empty: "Edge7"
    Roles roles;                       ///< by edge number, from 1
    LooseEdges looseEdges = LooseEdges::ByChain;
};

/// Collects the sources of one run into a CurveNetwork and remembers what came from where, so that
/// errors can name it. Not thread-safe.
class NetworkInput
{
public:
    /// All shapes of the run at once, because they share one plane: the global x-y plane if flat,
    /// else their own. Raises Python errors.
    void addShapes(const std::vector<Shape>& shapes, bool flat);
    /// points (n, 2), segments (m, 2) of indices from 0, markers (m) or empty; roles by segment
    /// from 0. One operand whose roles follow from how the segments connect. Raises Python errors.
    void addSegments(const Coordinates& points, const Indices& segments, const Indices& markers,
                     const std::string& name, const Roles& roles);
    /// Rings (n, 2), outer first; a last point equal to the first is left out. One operand with
    /// boundary rings, or constraints. Raises Python errors.
    void addPolygon(const std::vector<Coordinates>& rings, const std::string& name, Role role);

    /// Makes one operand of each source, whatever number of faces it has. Where two of its faces
    /// share a border, even-odd takes it away.
    void joinOperands();

    /// Ids of the curves that came from an edge or segment of a source (counted in the order of
    /// adding, all shapes of one call one by one); from any of it if number is negative.
    std::vector<std::uint32_t> curvesOf(std::size_t source, std::int64_t number) const;
    /// The operands that a source became, ascending.
    std::vector<std::uint32_t> operandsOf(std::size_t source) const;
    /// (x, y) in the plane's frame of a point in the space of the shapes.
    std::array<double, 2> toPlane(const std::array<double, 3>& point) const;

    const CurveNetwork& network() const { return network_; }
    const PlaneFrame& frame() const { return frame_; }
    double defaultWeld() const { return defaultWeld_; }
    double secondsToRead() const { return seconds_; }
    /// As pybind expects it: raises the error with the names of what its places point at.
    [[noreturn]] void raise(const Error& error) const;

private:
    struct Source
    {
        std::size_t firstCurve;
        std::size_t firstOperand;
        std::string kind; ///< "Edge", "Segment"
        std::vector<std::string> elements;
    };

    void beginSource(const std::string& kind, std::vector<std::string> elements);
    PlaceName nameOf(std::size_t source, std::uint32_t number) const;

    CurveNetwork network_;
    PlaneFrame frame_;
    double defaultWeld_ = 0.0;
    std::vector<Source> sources_;
    double seconds_ = 0.0;
};

} // namespace tessera::python
