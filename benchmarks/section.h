// SPDX-License-Identifier: MIT
#pragma once

// One section of the table that tools/bench prints: inputs, and the engines that are run on each.
//
// Each benchmarks/<name>.cpp is one executable and makes one Section:
//
//     int main(int argc, char** argv)
//     {
//         Section section("Delaunay triangulation of a million points", peers({"CGAL"}));
//         section.add("uniform", "Tessera", [&](Result& result) { ...; result.vertices = n; });
//         section.add("uniform", "CGAL", [&](Result& result) { ... });
//         section.expect("uniform", {"CGAL", 0.4, 120.0});
//         return section.run(argc, argv);
//     }
//
// The first engine of an input is ours; expect() says against which other one it is measured, and
// what it should reach. An engine without such a reference still gets its lines in the details.
// Measured are process CPU time (Google Benchmark; all engines in one process, in random order) and
// the greatest growth of the heap, while the function runs: so it prepares nothing that is not part
// of the job.

#include "heap_counter.h"

#include <benchmark/benchmark.h>

#ifdef TESSERA_HAS_CGAL
#include <CGAL/version.h>
#endif
#ifdef TESSERA_HAS_GEOS
#include <geos_c.h>
#endif
#ifdef TESSERA_HAS_BOOST
#include <boost/version.hpp>
#endif
#ifdef TESSERA_HAS_CLIPPER
#include <polyclipping/clipper.hpp>
#endif

#include <functional>
#include <initializer_list>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace tessera::bench
{

/// What an engine tells about one run.
struct Result
{
    std::size_t vertices = 0;              ///< of the result; 0: not counted, no bytes per vertex
    double seconds = 0.0; ///< of a peer that is a program of its own, by its own clock; else 0
    std::map<std::string, double> columns; ///< further columns of the details, by title
};

/// What the first engine should reach; 0: no target.
struct Expectation
{
    std::string reference {};    ///< the engine it is measured against
    double ratio = 0.0;          ///< its time over the reference's, at most
    double bytesPerVertex = 0.0; ///< at the heap's peak, at most
    std::map<std::string, double> atLeast {}; ///< of columns
    std::map<std::string, double> atMost {};
};

/// Those of the named peers that are compiled in, with their versions.
inline std::string peers(std::initializer_list<const char*> names)
{
    const std::map<std::string, std::string> versions {
#ifdef TESSERA_HAS_CGAL
        {"CGAL", CGAL_VERSION_STR},
#endif
#ifdef TESSERA_HAS_GEOS
        {"GEOS", GEOS_VERSION},
#endif
#ifdef TESSERA_HAS_BOOST
        {"Boost", BOOST_LIB_VERSION},
#endif
#ifdef TESSERA_HAS_CLIPPER
        {"Clipper", CLIPPER_VERSION},
#endif
    };
    std::string text;
    for (const char* name : names) {
        if (const auto found = versions.find(name); found != versions.end()) {
            text += (text.empty() ? "" : ", ") + found->first + ' ' + found->second;
        }
    }
    return text;
}

class Section
{
public:
    using Run = std::function<void(Result&)>;

    /// peers: see peers().
    Section(const std::string& title, const std::string& peers)
    {
        benchmark::AddCustomContext("title", title);
        benchmark::AddCustomContext("peers", peers);
        benchmark::AddCustomContext("compiler", kCompiler);
    }

    /// What the document says above the section's tables.
    void note(const std::string& text) { benchmark::AddCustomContext("note", text); }

    /// Names contain no '/'. repetitions: fewer for what takes seconds.
    void add(const std::string& input, const std::string& engine, Run run, int repetitions = 7)
    {
        benchmark::RegisterBenchmark((input + "/" + engine).c_str(),
                                     [run = std::move(run)](benchmark::State& state) {
                                         measure(state, run);
                                     })
            ->Iterations(1)
            ->Repetitions(repetitions)
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime();
    }

    void expect(const std::string& input, const Expectation& expectation)
    {
        std::ostringstream text;
        text << expectation.reference << '|' << expectation.ratio << '|'
             << expectation.bytesPerVertex << '|';
        for (const auto& [title, value] : expectation.atLeast) {
            text << title << ">=" << value << ';';
        }
        for (const auto& [title, value] : expectation.atMost) {
            text << title << "<=" << value << ';';
        }
        benchmark::AddCustomContext("expect " + input, text.str());
    }

    int run(int argc, char** argv)
    {
        benchmark::Initialize(&argc, argv);
        if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
            return 2;
        }
        benchmark::RunSpecifiedBenchmarks();
        return 0;
    }

private:
#ifdef __clang__
    static constexpr const char* kCompiler = __VERSION__;
#else
    static constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

    static void measure(benchmark::State& state, const Run& run)
    {
        for (auto _ : state) {
            const std::size_t before = HeapCounter::restart();
            Result result;
            run(result);
            const std::size_t growth = HeapCounter::peak() - before;
            if (result.vertices > 0) {
                const auto vertices = static_cast<double>(result.vertices);
                state.counters["vertices"] = vertices;
                state.counters["bytes/vertex"] = static_cast<double>(growth) / vertices;
            }
            if (result.seconds > 0.0) {
                state.counters["own ms"] = 1e3 * result.seconds;
            }
            for (const auto& [title, value] : result.columns) {
                state.counters[title] = value;
            }
        }
    }
};

} // namespace tessera::bench
