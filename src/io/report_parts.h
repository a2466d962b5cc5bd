// SPDX-License-Identifier: MIT
#pragma once

// What the reports of all commands have in common.

#include "imprint/overlay.h"
#include "pipeline.h"

#include <nlohmann/json.hpp>

#include <string>

namespace tessera
{

using Json = nlohmann::ordered_json;

/// report: MeshReport or OverlayReport.
template<class Report>
void addInput(Json& json, const Report& report)
{
    json["input"] = {{"points", report.inputPoints},
                     {"segments", report.inputSegments},
                     {"curves", report.inputCurves},
                     {"operands", report.inputOperands}};
}

inline void addRecovery(Json& json, const RecoveryReport& recovery)
{
    json["crossings"] = recovery.crossings;
    json["touches"] = recovery.touches;
    json["overlaps"] = recovery.overlaps;
    json["steiner_inserted"] = recovery.steinerInserted;
    json["steiner_removed"] = recovery.steinerRemoved;
}

inline Json secondsObject(const StageSeconds& s)
{
    return {{"read", s.read},         {"arrange", s.arrange},   {"sample", s.sample},
            {"triangulate", s.triangulate}, {"recover", s.recover}, {"color", s.color},
            {"refine", s.refine},     {"optimize", s.optimize}, {"extract", s.extract},
            {"write", s.write},       {"total", s.total}};
}

/// All of an overlay's report.
Json overlayReport(const OverlayResult& result, BooleanOperation operation);

inline std::string formatJson(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace tessera
