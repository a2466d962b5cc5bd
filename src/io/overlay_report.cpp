// SPDX-License-Identifier: MIT
#include "io/overlay_report.h"

#include "io/overlay_files.h"
#include "io/report_parts.h"
#include "io/system_memory.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tessera
{

namespace
{

std::size_t differentVertices(const OverlayResult& result)
{
    std::vector<std::uint8_t> used(result.recovered.triangulation.points.size(), 0);
    for (const std::uint32_t v : result.polygons.vertices) {
        used[v] = 1;
    }
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

std::size_t triangleCount(const OverlayResult& result)
{
    const auto& part = result.parts.partOfTriangle;
    return part.size()
        - static_cast<std::size_t>(std::count(part.begin(), part.end(), BooleanParts::kNoPart));
}

Json cellList(const OverlayResult& result, BooleanOperation operation)
{
    Json list = Json::array();
    const auto& parts = result.parts.parts;
    for (const OverlayLine& line : linesOf(result, operation)) {
        if (parts[line.firstPart].operands == OperandSets::kEmpty) {
            continue;
        }
        double area = 0.0;
        for (std::size_t p = line.firstPart; p < line.endPart; ++p) {
            area += parts[p].area;
        }
        Json operands = Json::array();
        result.parts.sets.forEach(parts[line.firstPart].operands, [&operands](OperandId operand) {
            operands.push_back(operand.value + 1);
        });
        list.push_back({{"area", area}, {"operands", std::move(operands)}});
    }
    return list;
}

} // namespace

Json overlayReport(const OverlayResult& result, BooleanOperation operation)
{
    const OverlayReport& report = result.report;
    Json json;
    json["version"] = TESSERA_VERSION;
    addInput(json, report);
    addRecovery(json, report.recovery);
    json["regions"] = result.parts.parts.size();
    json["vertices"] = differentVertices(result);
    json["triangles"] = triangleCount(result);
    json["quads"] = 0;
    json["area"] = report.area;
    Json areas = Json::array();
    for (const BooleanPart& part : result.parts.parts) {
        areas.push_back(part.area);
    }
    json["region_areas"] = std::move(areas);
    json["cells"] = cellList(result, operation);
    if (report.theta) {
        json["theta"] = {{"o", report.theta->o},
                         {"t", report.theta->t},
                         {"s", report.theta->s},
                         {"e", report.theta->e}};
    }
    json["max_displacement"] = report.recovery.maxDisplacement;
    json["snap_pixel"] = report.recovery.snapPixel;
    json["weld"] = report.weld;
    json["welded"] = report.welded;
    json["messages"] = report.messages;
    json["seconds"] = secondsObject(report.seconds);
    json["peak_memory_bytes"] = peakMemoryBytes();
    return json;
}

std::string formatReport(const OverlayResult& result, BooleanOperation operation)
{
    return formatJson(overlayReport(result, operation));
}

} // namespace tessera
