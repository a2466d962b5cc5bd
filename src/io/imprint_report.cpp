// SPDX-License-Identifier: MIT
#include "io/imprint_report.h"

#include "io/report_parts.h"

namespace tessera
{

namespace
{

Json fromOne(const std::vector<std::uint32_t>& numbers)
{
    Json list = Json::array();
    for (const std::uint32_t number : numbers) {
        list.push_back(number + 1);
    }
    return list;
}

Json mismatchList(const std::vector<Mismatch>& mismatches, const ImprintReportInput& input)
{
    Json list = Json::array();
    for (const Mismatch& mismatch : mismatches) {
        list.push_back({{"kind", nameOf(mismatch.kind)},
                        {"area", mismatch.area},
                        {"width", mismatch.width},
                        {"at", input.toSpace(mismatch.at)},
                        {"sources", fromOne(mismatch.sources)},
                        {"targets", fromOne(mismatch.targets)}});
    }
    return list;
}

Json historyOf(const ImprintResult& result, const ImprintReportInput& input, ImprintSide side)
{
    const auto& cellsOf =
        side == ImprintSide::Source ? result.cellsOfSource : result.cellsOfTarget;
    Json list = Json::array();
    for (std::size_t o = 0; o < input.side.size(); ++o) {
        if (input.side[o] != side) {
            continue;
        }
        const auto& cells = cellsOf[list.size()];
        double area = 0.0;
        for (const std::uint32_t cell : cells) {
            area += result.cells[cell].area;
        }
        list.push_back({{"name", result.overlay.input.operands[o].name},
                        {"area", area},
                        {"cells", fromOne(cells)}});
    }
    return list;
}

} // namespace

std::string formatReport(const ImprintResult& result, const ImprintReportInput& input)
{
    Json json = overlayReport(result.overlay, BooleanOperation::Cells);
    json.erase("theta");
    for (std::size_t c = 0; c < result.cells.size(); ++c) {
        json["cells"][c]["sources"] = fromOne(result.cells[c].sources);
        json["cells"][c]["targets"] = fromOne(result.cells[c].targets);
    }
    json["tolerance"] = result.tolerance;
    json["sources"] = historyOf(result, input, ImprintSide::Source);
    json["targets"] = historyOf(result, input, ImprintSide::Target);
    json["closed"] = mismatchList(result.closed, input);
    json["left"] = mismatchList(result.left, input);
    json["messages"] = result.messages;
    return formatJson(json);
}

} // namespace tessera
