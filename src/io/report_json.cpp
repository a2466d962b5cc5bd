// SPDX-License-Identifier: MIT
#include "io/report_json.h"

#include "io/report_parts.h"
#include "io/system_memory.h"

#include <nlohmann/json.hpp>

namespace tessera
{

namespace
{

void addQuality(Json& json, const QualityReport& quality)
{
    json["min_angle_deg"] = quality.minAngle;
    json["max_angle_deg"] = quality.maxAngle;
    json["angle_p01_deg"] = quality.angleP01;
    json["min_quality"] = quality.minQuality;
    json["mean_quality"] = quality.meanQuality;
    json["angle_histogram"] = quality.angleHistogram;
    json["quality_histogram"] = quality.qualityHistogram;
    Json worst = Json::array();
    for (const QualityReport::Worst& w : quality.worst) {
        worst.push_back({{"triangle", w.triangle},
                         {"place", {w.place.x, w.place.y}},
                         {"min_angle_deg", w.angle},
                         {"quality", w.quality}});
    }
    json["worst"] = worst;
}

Json unreachedList(const std::vector<Unreached>& unreached)
{
    Json list = Json::array();
    for (const Unreached& item : unreached) {
        list.push_back({{"what", item.what},
                        {"place", {item.place.x, item.place.y}},
                        {"value", item.value},
                        {"target", item.target}});
    }
    return list;
}

} // namespace

std::string formatReport(const MeshResult& result)
{
    const MeshReport& report = result.report;
    const auto& conformity = report.quality.sizeConformity;
    Json json;
    json["version"] = TESSERA_VERSION;
    addInput(json, report);
    addRecovery(json, report.recovery);
    json["regions"] = report.regions;
    json["vertices"] = result.mesh.nodes.size();
    json["triangles"] = result.mesh.triangles.size();
    json["quads"] = 0;
    json["area"] = report.area;
    json["region_areas"] = report.regionAreas;
    addQuality(json, report.quality);
    json["size_conformity"] = {{"min", conformity.min},
                               {"p05", conformity.p05},
                               {"median", conformity.median},
                               {"p95", conformity.p95},
                               {"max", conformity.max}};
    json["max_displacement"] = report.recovery.maxDisplacement;
    json["snap_pixel"] = report.recovery.snapPixel;
    json["unreached"] = unreachedList(report.unreached);
    json["default_size"] = report.defaultSize;
    if (report.count.target > 0) {
        json["count"] = {{"target", report.count.target},
                         {"reached", result.mesh.triangles.size()},
                         {"size", report.count.size},
                         {"runs", report.count.runs}};
    }
    json["weld"] = report.weld;
    json["welded"] = report.welded;
    json["messages"] = report.messages;
    json["seconds"] = secondsObject(report.seconds);
    json["peak_memory_bytes"] = peakMemoryBytes();
    return formatJson(json);
}

std::string formatReport(const MeshCheck& check)
{
    Json json;
    json["version"] = TESSERA_VERSION;
    json["valid"] = check.valid();
    json["problems"] = check.problems;
    json["warnings"] = check.warnings;
    json["vertices"] = check.nodes;
    json["unused_vertices"] = check.unusedNodes;
    json["edges"] = check.edges;
    json["triangles"] = check.triangles;
    json["quads"] = check.quads;
    json["order"] = check.order;
    json["area"] = check.area;
    json["outline_length"] = check.outlineLength;
    addQuality(json, check.quality);
    json["peak_memory_bytes"] = peakMemoryBytes();
    return formatJson(json);
}

} // namespace tessera
