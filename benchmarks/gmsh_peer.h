// SPDX-License-Identifier: MIT
#pragma once

// Gmsh's Frontal-Delaunay (algorithm 6) on the plate of plate.h, as a separate program. Its times are
// its own CPU seconds of meshing curves and faces, without reading and writing files.

#include "plate.h"

#include "io/read_text_mesh.h"
#include "io/text_file.h"
#include "mesh/quality.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>

namespace tessera::bench
{

/// What the shell command prints; nothing if it fails.
inline std::optional<std::string> outputOf(const std::string& command)
{
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) {
        return std::nullopt;
    }
    std::string text;
    std::array<char, 4096> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        text.append(buffer.data(), count);
    }
    return pclose(pipe) == 0 ? std::optional(text) : std::nullopt;
}

/// "gmsh 4.8.4", or nothing if it is not installed.
inline std::string gmshVersion()
{
    const std::optional<std::string> text = outputOf("gmsh --version");
    return text ? "gmsh " + text->substr(0, text->find('\n')) : "";
}

/// The plate in Gmsh's language, with the size as an expression in x and y.
inline void writePlateForGmsh(const std::filesystem::path& path, const std::string& size)
{
    std::ofstream out(path);
    out.precision(17);
    int points = 0;
    int curves = 0;
    int loops = 0;
    const auto point = [&](Vec2 p) {
        out << "Point(" << ++points << ") = {" << p.x << ", " << p.y << ", 0};\n";
        return points;
    };
    const auto loop = [&](int first, int last) {
        out << "Curve Loop(" << ++loops << ") = {" << first << ':' << last << "};\n";
    };
    const int corner[4] = {point({0, 0}), point({1, 0}), point({1, 1}), point({0, 1})};
    for (int i = 0; i < 4; ++i) {
        out << "Line(" << ++curves << ") = {" << corner[i] << ", " << corner[(i + 1) % 4] << "};\n";
    }
    loop(1, 4);
    for (const Hole& hole : kHoles) {
        const int center = point(hole.center);
        const int right = point(hole.center + Vec2 {hole.radius, 0});
        const int left = point(hole.center - Vec2 {hole.radius, 0});
        for (const auto& [from, to] : {std::pair {right, left}, std::pair {left, right}}) {
            out << "Circle(" << ++curves << ") = {" << from << ", " << center << ", " << to
                << "};\n";
        }
        loop(curves - 1, curves);
    }
    out << "Plane Surface(1) = {1:" << loops << "};\n";
    for (const auto& line : kLines) {
        const int from = point(line[0]);
        const int to = point(line[1]);
        out << "Line(" << ++curves << ") = {" << from << ", " << to << "};\n";
        out << "Curve{" << curves << "} In Surface{1};\n";
    }
    out << "Field[1] = MathEval;\nField[1].F = \"" << size << "\";\nBackground Field = 1;\n"
        << "Mesh.CharacteristicLengthFromPoints = 0;\n"
        << "Mesh.CharacteristicLengthExtendFromBoundary = 0;\nMesh.Algorithm = 6;\n"
        << "Mesh.MshFileVersion = 2.2;\n";
}

struct GmshRun
{
    double seconds = 0.0;
    std::size_t triangles = 0;
    QualityReport quality; ///< with conformity to the field
};

/// Meshes the plate. Throws std::runtime_error if Gmsh fails.
inline GmshRun meshWithGmsh(const std::string& expression, const SizeField& size)
{
    std::string folder = (std::filesystem::temp_directory_path() / "tessera-gmsh-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
        throw std::runtime_error("no temporary folder");
    }
    const std::filesystem::path input = std::filesystem::path(folder) / "plate.geo";
    const std::filesystem::path output = std::filesystem::path(folder) / "plate.msh";
    writePlateForGmsh(input, expression);
    const std::optional<std::string> log
        = outputOf("gmsh -2 -nt 1 '" + input.string() + "' -o '" + output.string() + "'");
    GmshRun run;
    if (log) {
        const std::regex done("Done meshing [12]D [^\\n]*CPU ([0-9.e+-]+)s");
        for (std::sregex_iterator it(log->begin(), log->end(), done), end; it != end; ++it) {
            run.seconds += std::stod((*it)[1]);
        }
        const RawMesh raw = parseMsh(readTextFile(output), output.string());
        Mesh mesh;
        for (const auto& p : raw.nodes) {
            mesh.nodes.push_back({p[0], p[1]});
        }
        for (const RawMesh::Cell& cell : raw.cells) {
            if (cell.kind == CellKind::Triangle3) {
                const auto v = raw.nodesOfCell(cell);
                mesh.triangles.push_back({v[0], v[1], v[2]});
            }
        }
        run.triangles = mesh.triangles.size();
        run.quality = measureQuality(mesh, &size);
    }
    std::filesystem::remove_all(folder);
    if (run.triangles == 0 || !(run.seconds > 0.0)) {
        throw std::runtime_error("gmsh failed");
    }
    return run;
}

} // namespace tessera::bench
