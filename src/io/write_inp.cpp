// SPDX-License-Identifier: MIT
#include "io/group_names.h"
#include "io/text_builder.h"
#include "io/write_text_mesh.h"

#include <algorithm>
#include <charconv>

namespace tessera
{

namespace
{

/// A coordinate in at most 20 characters: exact if that is enough, else rounded.
void appendCoordinate(TextBuilder& out, double value)
{
    constexpr std::ptrdiff_t kMostCharacters = 20;
    char digits[32];
    auto result = std::to_chars(digits, digits + sizeof digits, value);
    for (int precision = 17; result.ptr - digits > kMostCharacters; --precision) {
        result = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general,
                               precision);
    }
    out << std::string_view(digits, static_cast<std::size_t>(result.ptr - digits));
}

void appendSet(TextBuilder& out, const char* keyword, const std::string& name,
               const std::vector<std::uint32_t>& members)
{
    constexpr std::size_t kPerLine = 16;
    out << '*' << keyword << ", " << keyword << '=' << name << '\n';
    for (std::size_t i = 0; i < members.size(); ++i) {
        const bool ends = i % kPerLine == kPerLine - 1 || i + 1 == members.size();
        out << members[i] + 1 << (ends ? "\n" : ", ");
    }
}

/// The nodes of a group of edges, ascending.
std::vector<std::uint32_t> nodesOfEdges(const Mesh& mesh, const std::vector<std::uint32_t>& edges)
{
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t e : edges) {
        nodes.insert(nodes.end(), mesh.edges[e].begin(), mesh.edges[e].end());
        if (!mesh.edgeMidNodes.empty()) {
            nodes.push_back(mesh.edgeMidNodes[e]);
        }
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

void appendElements(TextBuilder& out, const Mesh& mesh)
{
    const bool second = mesh.order() == 2;
    out << "*ELEMENT, TYPE=" << (second ? "S6" : "S3") << ", ELSET=Eall\n";
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        out << t + 1;
        for (std::uint32_t node : mesh.triangles[t]) {
            out << ", " << node + 1;
        }
        if (second) {
            for (int opposite : {2, 0, 1}) {
                out << ", " << mesh.triangleMidNodes[t][opposite] + 1;
            }
        }
        out << '\n';
    }
}

} // namespace

std::string formatInp(const Mesh& mesh)
{
    TextBuilder out;
    out.reserve(50 * (mesh.nodes.size() + mesh.triangles.size()) + 4096);
    out << "** Mesh by Tessera " << TESSERA_VERSION << '\n' << "*NODE, NSET=Nall\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        out << i + 1 << ", ";
        appendCoordinate(out, mesh.nodes[i].x);
        out << ", ";
        appendCoordinate(out, mesh.nodes[i].y);
        out << ", 0\n";
    }
    if (!mesh.triangles.empty()) {
        appendElements(out, mesh);
    }
    std::vector<std::string_view> wanted;
    for (const Group& group : mesh.groups) {
        wanted.emplace_back(group.name);
    }
    const std::vector<std::string> names = deckNames(wanted, {"Eall", "Nall"});
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        const Group& group = mesh.groups[g];
        if (group.members.empty()) {
            continue;
        }
        if (group.kind == GroupKind::Triangles) {
            appendSet(out, "ELSET", names[g], group.members);
        }
        else {
            appendSet(out, "NSET", names[g],
                      group.kind == GroupKind::Edges ? nodesOfEdges(mesh, group.members)
                                                     : group.members);
        }
    }
    return out.take();
}

} // namespace tessera
