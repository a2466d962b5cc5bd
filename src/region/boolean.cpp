// SPDX-License-Identifier: MIT
//
// The paper's Algorithm 2 for any number of operands. Faces (triangles that no subsegment
// separates) are colored by one walk that carries all winding numbers (cover.h); each gets a label,
// or none if the operation does not keep it; faces with one label across a subsegment are one part.
#include "region/boolean.h"

#include "base/error.h"
#include "region/borders.h"
#include "region/cover.h"
#include "region/faces.h"
#include "region/marked_points.h"
#include "region/subsegment_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tessera
{

namespace
{

class BooleanColoring
{
public:
    BooleanColoring(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
                    const BooleanOptions& options, Execution& execution)
        : recovered_(recovered)
        , operandCount_(network.operands.size())
        , options_(options)
        , execution_(execution)
        , graph_(recovered)
        , borders_(findBorders(recovered, network, pslg, options.fill, graph_))
        , faces_(buildFaces(recovered, graph_, execution))
        , marked_(markFaces(recovered, network, pslg, faces_, options.fill != FillRule::All,
                            execution))
        , byCell_(options.operation == BooleanOperation::Cells)
    {
        result_.messages = borders_.messages;
        result_.messages.insert(result_.messages.end(), marked_.messages.begin(),
                                marked_.messages.end());
    }

    BooleanParts run()
    {
        colorFaces();
        joinFaces();
        numberParts();
        colorTriangles();
        return std::move(result_);
    }

private:
    static constexpr std::uint32_t kNoLabel = 0xffffffffU;

    void colorFaces()
    {
        label_.assign(faces_.faceCount, kNoLabel);
        if (byCell_ || options_.priority != Priority::None) {
            result_.sets = OperandSets(operandCount_);
        }
        if (byCell_) {
            setOfFace_.assign(faces_.faceCount, OperandSets::kEmpty);
        }
        if (operandCount_ == 2) {
            thetaOfFace_.assign(faces_.faceCount, Theta::E);
        }
        Cover cover(options_.fill, operandCount_);
        walkFaces(faces_, borders_, cover, execution_,
                  [this](std::uint32_t face, const Cover& here, std::uint32_t entry) {
                      if (byCell_) {
                          noteSet(face, here, entry);
                      }
                      colorFace(face, coveringAt(face, here));
                  });
    }

    /// The set of a face differs from that of the face before it by what their border changes.
    void noteSet(std::uint32_t face, const Cover& here, std::uint32_t entry)
    {
        if (entry == kNoLink) {
            return;
        }
        const std::uint32_t from = faces_.across(entry, face);
        const bool backLeftToRight = faces_.links[entry].left == face;
        OperandSetId set = setOfFace_[from];
        for (const BorderCrossing& c : borders_.of(faces_.links[entry].subsegment)) {
            if (here.coversHere(c) != here.coversBeyond(c, backLeftToRight)) {
                set = result_.sets.toggled(set, OperandId(c.operand));
            }
        }
        setOfFace_[face] = set;
    }

    /// The operands that cover a face and of which no hole point removes it.
    std::span<const OperandId> coveringAt(std::uint32_t face, const Cover& here)
    {
        if (marked_.hasRemoval.empty() || marked_.hasRemoval[face] == 0) {
            return here.covering();
        }
        left_.clear();
        for (const OperandId operand : here.covering()) {
            if (!std::binary_search(marked_.removed.begin(), marked_.removed.end(),
                                    std::pair(face, operand.value))) {
                left_.push_back(operand);
            }
        }
        return left_;
    }

    void colorFace(std::uint32_t face, std::span<const OperandId> covering)
    {
        if (!thetaOfFace_.empty()) {
            const auto isIn = [covering](std::uint32_t operand) {
                return std::find(covering.begin(), covering.end(), OperandId(operand))
                    != covering.end();
            };
            thetaOfFace_[face] = thetaOf(isIn(0), isIn(1));
        }
        if (face == 0 || !isKept(options_.operation, covering, operandCount_)) {
            return;
        }
        label_[face] = 0;
        if (options_.priority != Priority::None) {
            label_[face] = (options_.priority == Priority::First ? covering.front()
                                                                 : covering.back())
                               .value;
        }
    }

    std::uint32_t rootOf(std::uint32_t face)
    {
        while (parent_[face] != face) {
            parent_[face] = parent_[parent_[face]];
            face = parent_[face];
        }
        return face;
    }

    /// Faces are numbered by their lowest triangle, and the lowest face of a part is its root.
    void joinFaces()
    {
        parent_.resize(faces_.faceCount);
        std::iota(parent_.begin(), parent_.end(), 0U);
        if (byCell_) {
            return;
        }
        for (const FaceLink& link : faces_.links) {
            if (label_[link.left] != kNoLabel && label_[link.left] == label_[link.right]) {
                const std::uint32_t p = rootOf(link.left);
                const std::uint32_t q = rootOf(link.right);
                parent_[std::max(p, q)] = std::min(p, q);
            }
        }
    }

    void numberParts()
    {
        std::vector<std::uint32_t> roots;
        for (std::uint32_t f = 0; f < faces_.faceCount; ++f) {
            if (label_[f] != kNoLabel && rootOf(f) == f) {
                roots.push_back(f);
            }
        }
        if (options_.priority != Priority::None && !byCell_) {
            std::stable_sort(roots.begin(), roots.end(), [this](std::uint32_t f, std::uint32_t g) {
                return label_[f] < label_[g];
            });
        }
        partOfFace_.assign(faces_.faceCount, BooleanParts::kNoPart);
        for (const std::uint32_t root : roots) {
            partOfFace_[root] = static_cast<std::uint32_t>(result_.parts.size());
            result_.parts.push_back(describe(root));
        }
        for (std::uint32_t f = 0; f < faces_.faceCount; ++f) {
            if (label_[f] != kNoLabel) {
                partOfFace_[f] = partOfFace_[rootOf(f)];
            }
        }
    }

    BooleanPart describe(std::uint32_t face)
    {
        BooleanPart part;
        if (options_.priority != Priority::None) {
            part.owner = OperandId(label_[face]);
            part.operands = result_.sets.toggled(OperandSets::kEmpty, part.owner);
        }
        else if (byCell_) {
            part.operands = setOfFace_[face];
            removeHoles(face, part.operands);
        }
        return part;
    }

    void removeHoles(std::uint32_t face, OperandSetId& set)
    {
        if (marked_.hasRemoval.empty() || marked_.hasRemoval[face] == 0) {
            return;
        }
        auto entry = std::lower_bound(marked_.removed.begin(), marked_.removed.end(),
                                      std::pair(face, 0U));
        for (; entry != marked_.removed.end() && entry->first == face; ++entry) {
            if (result_.sets.contains(set, OperandId(entry->second))) {
                set = result_.sets.toggled(set, OperandId(entry->second));
            }
        }
    }

    void colorTriangles()
    {
        const Triangulation& t = recovered_.triangulation;
        result_.partOfTriangle.assign(t.triangles.size(), BooleanParts::kNoPart);
        if (!thetaOfFace_.empty()) {
            result_.theta.assign(t.triangles.size(), Theta::E);
        }
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            if (!t.isFinite(i)) {
                continue;
            }
            const std::uint32_t face = faces_.faceOfTriangle[i];
            if (!thetaOfFace_.empty()) {
                result_.theta[i] = thetaOfFace_[face];
            }
            const std::uint32_t part = partOfFace_[face];
            if (part != BooleanParts::kNoPart) {
                const auto& v = t.triangles[i].v;
                result_.partOfTriangle[i] = part;
                result_.parts[part].area +=
                    0.5 * cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]);
            }
        }
    }

    const RecoveryResult& recovered_;
    std::size_t operandCount_;
    BooleanOptions options_;
    Execution& execution_;
    SubsegmentGraph graph_;
    Borders borders_;
    FaceGraph faces_;
    MarkedFaces marked_;
    bool byCell_;
    std::vector<std::uint32_t> label_; ///< by face
    std::vector<OperandSetId> setOfFace_;
    std::vector<Theta> thetaOfFace_;
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint32_t> partOfFace_;
    std::vector<OperandId> left_;
    BooleanParts result_;
};

} // namespace

BooleanParts colorBoolean(const RecoveryResult& recovered, const CurveNetwork& network,
                          const Pslg& pslg, const BooleanOptions& options, Execution& execution)
{
    if (options.fill == FillRule::Hull) {
        throw Error(ErrorKind::InvalidOption,
                    "The fill rule hull is for meshing; choose another one for an overlay.");
    }
    return BooleanColoring(recovered, network, pslg, options, execution).run();
}

} // namespace tessera
