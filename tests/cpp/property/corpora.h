// SPDX-License-Identifier: MIT
#pragma once

// Planar straight-line graphs of other projects, with the counts of their exact arrangement.

#include "corpora_folder.h"
#include "io/text_file.h"
#include "recover/recovery_case.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tessera::test
{

struct ExactCounts
{
    std::size_t vertices;  ///< different points, and crossings
    std::size_t edges;
    std::size_t faces;     ///< bounded
    std::size_t crossings; ///< that are no points
};

struct CorpusPslg
{
    std::string name; ///< path inside the corpora
    std::size_t segments;
    bool wellConditioned;
    ExactCounts exact;
};

/// Precondition: TESSERA_NEEDS_CORPORA().
inline std::vector<CorpusPslg> corpusPslgs()
{
    std::vector<CorpusPslg> result;
    const auto json = nlohmann::json::parse(readTextFile(corpora() / "MANIFEST.json"));
    for (const auto& [name, entry] : json.items()) {
        if (entry.at("kind") == "pslg") {
            const auto& expect = entry.at("expect");
            const auto& exact = expect.at("exact_arrangement");
            result.push_back({name,
                              entry.at("segments"),
                              expect.at("well_conditioned"),
                              {exact.at("V"), exact.at("E"), exact.at("bounded_faces"),
                               exact.at("crossing_points")}});
        }
    }
    return result;
}

inline std::string readPacked(const std::filesystem::path& path)
{
    if (path.extension() != ".gz") {
        return readTextFile(path);
    }
    const std::string command = "gzip -dc '" + path.string() + "'";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    if (pipe == nullptr) {
        throw std::runtime_error("cannot run " + command);
    }
    std::string text;
    std::array<char, 65536> buffer;
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;) {
        text.append(buffer.data(), n);
    }
    return text;
}

/// Every point and segment as the file has them; what surrounds them is not read.
inline RawPslg readCorpusPslg(const std::string& name)
{
    const std::string text = readPacked(corpora() / name);
    LineReader lines(text, name);
    RawPslg raw;
    lines.need("the number of points");
    const std::size_t pointCount = lines.count("number of points");
    for (std::size_t i = 0; i < pointCount; ++i) {
        lines.need("a point");
        lines.count("number");
        const double x = lines.number("x");
        raw.addPoint({x, lines.number("y")});
    }
    lines.need("the number of segments");
    const std::size_t segmentCount = lines.count("number of segments");
    for (std::size_t i = 0; i < segmentCount; ++i) {
        lines.need("a segment");
        lines.count("number");
        const std::size_t a = lines.count("first end");
        raw.segments.emplace_back(a - 1, lines.count("second end") - 1);
    }
    return raw;
}

} // namespace tessera::test
