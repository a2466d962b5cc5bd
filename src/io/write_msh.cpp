// SPDX-License-Identifier: MIT
#include "io/text_builder.h"
#include "io/write_text_mesh.h"

#include "base/box2.h"

#include <map>
#include <utility>

namespace tessera
{

namespace
{

/// Gmsh's numbers of element types.
enum GmshType
{
    kLine2 = 1,
    kTriangle3 = 2,
    kLine3 = 8,
    kTriangle6 = 9,
    kPoint = 15,
};

/// Items of one dimension by the combination of groups that they are in.
struct Classes
{
    std::vector<std::uint32_t> classOf;              ///< by item
    std::vector<std::vector<std::uint32_t>> groups;  ///< by class: physical tags, ascending
    std::vector<std::vector<std::uint32_t>> members; ///< by class: items
};

Classes classify(const Mesh& mesh, GroupKind kind, std::size_t items)
{
    Classes result;
    result.classOf.assign(items, 0);
    result.groups.emplace_back();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> extended;
    for (std::uint32_t g = 0; g < mesh.groups.size(); ++g) {
        if (mesh.groups[g].kind != kind) {
            continue;
        }
        for (std::uint32_t item : mesh.groups[g].members) {
            const std::uint32_t old = result.classOf[item];
            const auto [at, isNew] = extended.try_emplace({old, g}, result.groups.size());
            if (isNew) {
                result.groups.push_back(result.groups[old]);
                result.groups.back().push_back(g + 1);
            }
            result.classOf[item] = at->second;
        }
    }
    result.members.resize(result.groups.size());
    for (std::uint32_t item = 0; item < items; ++item) {
        result.members[result.classOf[item]].push_back(item);
    }
    return result;
}

class MshText
{
public:
    explicit MshText(const Mesh& mesh)
        : mesh_(mesh)
        , surfaces_(classify(mesh, GroupKind::Triangles, mesh.triangles.size()))
        , curves_(classify(mesh, GroupKind::Edges, mesh.edges.size()))
        , points_(classify(mesh, GroupKind::Nodes, mesh.nodes.size()))
    {
        for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
            if (points_.classOf[node] != 0) {
                pointNodes_.push_back(node);
            }
        }
    }

    std::string run()
    {
        out_.reserve(60 * (mesh_.nodes.size() + mesh_.triangles.size()) + 4096);
        out_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
        physicalNames();
        entities();
        nodes();
        elements();
        return out_.take();
    }

private:
    void physicalNames()
    {
        out_ << "$PhysicalNames\n" << mesh_.groups.size() << '\n';
        for (std::size_t g = 0; g < mesh_.groups.size(); ++g) {
            const GroupKind kind = mesh_.groups[g].kind;
            out_ << (kind == GroupKind::Triangles ? 2 : kind == GroupKind::Edges ? 1 : 0) << ' '
                 << g + 1 << " \"";
            for (char c : mesh_.groups[g].name) {
                out_ << (c == '"' || (c >= '\0' && c < ' ') ? '_' : c);
            }
            out_ << "\"\n";
        }
        out_ << "$EndPhysicalNames\n";
    }

    static std::size_t usedCount(const Classes& classes)
    {
        std::size_t count = 0;
        for (const auto& members : classes.members) {
            count += members.empty() ? 0 : 1;
        }
        return count;
    }

    void tags(const std::vector<std::uint32_t>& tags)
    {
        out_ << ' ' << tags.size();
        for (std::uint32_t tag : tags) {
            out_ << ' ' << tag;
        }
    }

    template<class Elements>
    void boxedEntities(const Classes& classes, const Elements& elements)
    {
        for (std::size_t c = 0; c < classes.members.size(); ++c) {
            if (classes.members[c].empty()) {
                continue;
            }
            Box2 box;
            for (std::uint32_t item : classes.members[c]) {
                for (std::uint32_t node : elements[item]) {
                    box.add(mesh_.nodes[node]);
                }
            }
            out_ << c + 1 << ' ' << box.min.x << ' ' << box.min.y << " 0 " << box.max.x << ' '
                 << box.max.y << " 0";
            tags(classes.groups[c]);
            out_ << " 0\n";
        }
    }

    void entities()
    {
        out_ << "$Entities\n"
             << pointNodes_.size() << ' ' << usedCount(curves_) << ' ' << usedCount(surfaces_)
             << " 0\n";
        for (std::size_t i = 0; i < pointNodes_.size(); ++i) {
            const Vec2 p = mesh_.nodes[pointNodes_[i]];
            out_ << i + 1 << ' ' << p.x << ' ' << p.y << " 0";
            tags(points_.groups[points_.classOf[pointNodes_[i]]]);
            out_ << '\n';
        }
        boxedEntities(curves_, mesh_.edges);
        boxedEntities(surfaces_, mesh_.triangles);
        out_ << "$EndEntities\n";
    }

    /// Every node on the entity of the lowest dimension that has it: (dimension, tag) by node.
    std::vector<std::pair<std::uint8_t, std::uint32_t>> classifyNodes() const
    {
        std::vector<std::pair<std::uint8_t, std::uint32_t>> entity(mesh_.nodes.size(), {2, 1});
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            const std::pair<std::uint8_t, std::uint32_t> surface {2, surfaces_.classOf[t] + 1};
            for (int i = 0; i < 3; ++i) {
                entity[mesh_.triangles[t][i]] = surface;
                if (!mesh_.triangleMidNodes.empty()) {
                    entity[mesh_.triangleMidNodes[t][i]] = surface;
                }
            }
        }
        for (std::uint32_t e = 0; e < mesh_.edges.size(); ++e) {
            const std::pair<std::uint8_t, std::uint32_t> curve {1, curves_.classOf[e] + 1};
            entity[mesh_.edges[e][0]] = curve;
            entity[mesh_.edges[e][1]] = curve;
            if (!mesh_.edgeMidNodes.empty()) {
                entity[mesh_.edgeMidNodes[e]] = curve;
            }
        }
        for (std::uint32_t i = 0; i < pointNodes_.size(); ++i) {
            entity[pointNodes_[i]] = {0, i + 1};
        }
        return entity;
    }

    void nodes()
    {
        std::map<std::pair<std::uint8_t, std::uint32_t>, std::vector<std::uint32_t>> blocks;
        const auto entity = classifyNodes();
        for (std::uint32_t node = 0; node < entity.size(); ++node) {
            blocks[entity[node]].push_back(node);
        }
        out_ << "$Nodes\n"
             << blocks.size() << ' ' << mesh_.nodes.size() << ' ' << (mesh_.nodes.empty() ? 0 : 1)
             << ' ' << mesh_.nodes.size() << '\n';
        for (const auto& [where, members] : blocks) {
            out_ << static_cast<int>(where.first) << ' ' << where.second << " 0 " << members.size()
                 << '\n';
            for (std::uint32_t node : members) {
                out_ << node + 1 << '\n';
            }
            for (std::uint32_t node : members) {
                out_ << mesh_.nodes[node].x << ' ' << mesh_.nodes[node].y << " 0\n";
            }
        }
        out_ << "$EndNodes\n";
    }

    void elements()
    {
        const std::size_t count =
            pointNodes_.size() + mesh_.edges.size() + mesh_.triangles.size();
        out_ << "$Elements\n"
             << pointNodes_.size() + usedCount(curves_) + usedCount(surfaces_) << ' ' << count
             << ' ' << (count == 0 ? 0 : 1) << ' ' << count << '\n';
        for (std::size_t i = 0; i < pointNodes_.size(); ++i) {
            out_ << "0 " << i + 1 << ' ' << static_cast<int>(kPoint) << " 1\n"
                 << ++number_ << ' ' << pointNodes_[i] + 1 << '\n';
        }
        const bool second = mesh_.order() == 2;
        forEachMember(curves_, 1, second ? kLine3 : kLine2, [&](std::uint32_t e) {
            out_ << ' ' << mesh_.edges[e][0] + 1 << ' ' << mesh_.edges[e][1] + 1;
            if (second) {
                out_ << ' ' << mesh_.edgeMidNodes[e] + 1;
            }
        });
        forEachMember(surfaces_, 2, second ? kTriangle6 : kTriangle3, [&](std::uint32_t t) {
            for (std::uint32_t node : mesh_.triangles[t]) {
                out_ << ' ' << node + 1;
            }
            if (second) {
                for (int opposite : {2, 0, 1}) {
                    out_ << ' ' << mesh_.triangleMidNodes[t][opposite] + 1;
                }
            }
        });
        out_ << "$EndElements\n";
    }

    template<class Nodes>
    void forEachMember(const Classes& classes, int dimension, GmshType type, Nodes&& nodes)
    {
        for (std::size_t c = 0; c < classes.members.size(); ++c) {
            if (classes.members[c].empty()) {
                continue;
            }
            out_ << dimension << ' ' << c + 1 << ' ' << static_cast<int>(type) << ' '
                 << classes.members[c].size() << '\n';
            for (std::uint32_t item : classes.members[c]) {
                out_ << ++number_;
                nodes(item);
                out_ << '\n';
            }
        }
    }

    const Mesh& mesh_;
    Classes surfaces_;
    Classes curves_;
    Classes points_;
    std::vector<std::uint32_t> pointNodes_;
    std::size_t number_ = 0;
    TextBuilder out_;
};

} // namespace

std::string formatMsh(const Mesh& mesh)
{
    return MshText(mesh).run();
}

} // namespace tessera
