// SPDX-License-Identifier: MIT

// Cells, areas and history of an imprint against those that GEOS derives from fine polygons.

#include "imprint/geos.h"
#include "imprint/imprint_cases.h"
#include "io/overlay_files.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>

namespace tessera
{
namespace
{

using Numbers = std::vector<std::uint32_t>;

void appendNumber(std::string& text, double value)
{
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end.ptr);
}

/// The outline of an operand with one loop, its arcs in many pieces.
std::string finePolygon(const CurveNetwork& network, std::uint32_t operand, int pieces)
{
    std::string text = "POLYGON ((";
    std::string first;
    for (const NetworkCurve& curve : network.curves) {
        if (curve.operand.value != operand) {
            continue;
        }
        for (int i = 0; i < (curve.geometry ? pieces : 1); ++i) {
            Vec2 p = network.points[curve.start.index()];
            if (i > 0) {
                const double a = curve.geometry->first();
                p = curve.geometry->point(a + (curve.geometry->last() - a) * i / pieces);
            }
            std::string corner;
            appendNumber(corner, p.x);
            corner += ' ';
            appendNumber(corner, p.y);
            first = first.empty() ? corner : first;
            text += corner + ", ";
        }
    }
    return text + first + "))";
}

std::vector<test::Geos::Geometry> finePolygons(const test::Geos& geos, const ImprintCase& c)
{
    std::vector<test::Geos::Geometry> polygons;
    for (std::uint32_t o = 0; o < c.side.size(); ++o) {
        polygons.push_back(geos.read(finePolygon(c.network, o, 40000)));
        EXPECT_EQ(geos.whyInvalid(polygons.back().get()), "");
    }
    return polygons;
}

TEST(ImprintOracle, ThreeSourcesAndFourTargetsThatCross)
{
    const test::Geos geos;
    const ImprintCase c = plateAndDisk();
    const ImprintResult result = imprint(c);
    const auto fine = finePolygons(geos, c);
    std::size_t cells = 0;
    for (std::uint32_t s = 0; s < 3; ++s) {
        for (std::uint32_t t = 0; t < 4; ++t) {
            const auto both = geos.own(
                GEOSIntersection_r(geos.context(), fine[s].get(), fine[3 + t].get()));
            std::multiset<double> expected;
            for (const std::string& polygon : geos.polygonsOf(both.get())) {
                const double area = geos.area(geos.read(polygon).get());
                if (area > 1e-9) { // rounding makes slivers along common borders
                    expected.insert(area);
                }
            }
            std::multiset<double> found;
            for (const std::uint32_t cell : result.cellsOfSource[s]) {
                if (result.cells[cell].targets == Numbers {t}) {
                    EXPECT_EQ(result.cells[cell].sources, Numbers {s});
                    found.insert(result.cells[cell].area);
                }
            }
            ASSERT_EQ(found.size(), expected.size()) << s << ", " << t;
            for (auto f = found.begin(), e = expected.begin(); f != found.end(); ++f, ++e) {
                EXPECT_NEAR(*f, *e, 1e-7);
            }
            cells += expected.size();
        }
    }
    EXPECT_EQ(result.cells.size(), cells);
}

/// A star-shaped polygon.
Ring randomRing(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Vec2 center {4.0 * unit(random), 4.0 * unit(random)};
    const std::size_t corners = 3 + random() % 8;
    Ring ring;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.8 * unit(random))
            / static_cast<double>(corners);
        const double radius = 0.5 + 1.5 * unit(random);
        ring.push_back(center + radius * Vec2 {std::cos(angle), std::sin(angle)});
    }
    return ring;
}

/// Area by set of covering operands, from GEOS: what all of the set cover and nothing else.
double areaOfSet(const test::Geos& geos, const std::vector<test::Geos::Geometry>& polygons,
                 const std::set<std::uint32_t>& members)
{
    test::Geos::Geometry rest = geos.own(
        GEOSGeom_clone_r(geos.context(), polygons[*members.begin()].get()));
    for (std::uint32_t o = 0; o < polygons.size(); ++o) {
        const GEOSGeometry* other = polygons[o].get();
        rest = geos.own(members.contains(o)
                            ? GEOSIntersection_r(geos.context(), rest.get(), other)
                            : GEOSDifference_r(geos.context(), rest.get(), other));
    }
    return geos.area(rest.get());
}

TEST(ImprintOracle, RandomSourcesAndTargets)
{
    const test::Geos geos;
    std::mt19937_64 random(12);
    for (int run = 0; run < 40; ++run) {
        SCOPED_TRACE(run);
        ImprintCase c;
        const std::size_t sources = 1 + random() % 4;
        const std::size_t targets = 1 + random() % 4;
        for (std::size_t i = 0; i < sources; ++i) {
            addSource(c, randomRing(random));
        }
        for (std::size_t i = 0; i < targets; ++i) {
            addTarget(c, randomRing(random));
        }
        const ImprintResult result = imprint(c);
        const auto fine = finePolygons(geos, c);

        std::map<std::set<std::uint32_t>, double> found;
        double sum = 0.0;
        std::size_t mismatched = 0;
        for (const ImprintCell& cell : result.cells) {
            std::set<std::uint32_t> members(cell.sources.begin(), cell.sources.end());
            for (const std::uint32_t t : cell.targets) {
                members.insert(static_cast<std::uint32_t>(sources) + t);
            }
            found[members] += cell.area;
            sum += cell.area;
            mismatched += cell.sources.size() == 1 && cell.targets.size() == 1 ? 0 : 1;
        }
        for (const auto& [members, area] : found) {
            EXPECT_NEAR(area, areaOfSet(geos, fine, members), 1e-9);
        }
        test::Geos::Geometry all = geos.own(GEOSGeom_clone_r(geos.context(), fine[0].get()));
        for (const auto& polygon : fine) {
            all = geos.own(GEOSUnion_r(geos.context(), all.get(), polygon.get()));
        }
        EXPECT_NEAR(sum, geos.area(all.get()), 1e-9);
        std::size_t reported = 0;
        for (const Mismatch& mismatch : result.left) {
            reported += mismatch.kind == MismatchKind::Gap ? 0 : 1;
        }
        EXPECT_EQ(reported, mismatched);
        EXPECT_TRUE(result.closed.empty());
    }
}

/// Any corners, edges cross each other and themselves; on a coarse grid in every other case.
Ring tangledRing(std::mt19937_64& random, bool grid)
{
    std::uniform_real_distribution<double> unit(0.0, 10.0);
    Ring ring;
    for (std::size_t i = 3 + random() % 8; i > 0; --i) {
        const Vec2 p {unit(random), unit(random)};
        ring.push_back(grid ? Vec2 {std::floor(p.x), std::floor(p.y)} : p);
    }
    return ring;
}

TEST(ImprintOracle, AnyInputWithAnyToleranceGivesValidCells)
{
    const test::Geos geos;
    std::mt19937_64 random(3);
    for (int run = 0; run < 150; ++run) {
        SCOPED_TRACE(run);
        ImprintCase c;
        for (std::size_t i = 1 + random() % 3; i > 0; --i) {
            addSource(c, tangledRing(random, run % 2 == 0));
        }
        for (std::size_t i = 1 + random() % 3; i > 0; --i) {
            addTarget(c, tangledRing(random, run % 2 == 0));
        }
        ImprintOptions options;
        options.tolerance = std::pow(10.0, -6.0 + static_cast<double>(random() % 8));
        ImprintResult result;
        ASSERT_NO_THROW(result = imprint(c, options)) << options.tolerance;
        ASSERT_EQ(result.cells.size(), result.overlay.polygons.size());
        double sum = 0.0;
        for (const ImprintCell& cell : result.cells) {
            EXPECT_GT(cell.area, 0.0);
            EXPECT_FALSE(cell.sources.empty() && cell.targets.empty());
            sum += cell.area;
        }
        if (result.cells.empty()) {
            continue;
        }
        const std::string text = formatWkt(result.overlay, BooleanOperation::Cells);
        test::Geos::Geometry all;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            auto cell = geos.read(line);
            ASSERT_EQ(geos.whyInvalid(cell.get()), "");
            all = all ? geos.own(GEOSUnion_r(geos.context(), all.get(), cell.get()))
                      : std::move(cell);
        }
        // Cells do not overlap.
        EXPECT_NEAR(geos.area(all.get()), sum, 1e-9 * sum);
        for (const Mismatch& closed : result.closed) {
            EXPECT_LE(closed.width, options.tolerance);
        }
    }
}

TEST(ImprintOracle, RandomDisturbancesWithinTheToleranceAreClosed)
{
    // Two partitions of a square by broken lines, every face drawn on its own and inexactly.
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
    std::uniform_real_distribution<double> middle(3.0, 7.0);
    for (int run = 0; run < 20; ++run) {
        SCOPED_TRACE(run);
        const auto shaken = [&](Ring ring) {
            for (Vec2& p : ring) {
                p = p + Vec2 {noise(random), noise(random)};
            }
            return ring;
        };
        const double a = middle(random);
        const double b = middle(random);
        const double d = middle(random);
        const double e = middle(random);
        ImprintCase c;
        addSource(c, shaken({{0, 0}, {a, 0}, {d, 5}, {b, 10}, {0, 10}}));
        addSource(c, shaken({{a, 0}, {10, 0}, {10, 10}, {b, 10}, {d, 5}}));
        addTarget(c, shaken({{0, 0}, {10, 0}, {10, e}, {0, a}}));
        addTarget(c, shaken({{0, a}, {10, e}, {10, 10}, {0, 10}}));
        ImprintOptions options;
        options.tolerance = 1e-3;
        const ImprintResult result = imprint(c, options);
        EXPECT_TRUE(result.left.empty());
        double sum = 0.0;
        for (const ImprintCell& cell : result.cells) {
            EXPECT_EQ(cell.sources.size(), 1U);
            EXPECT_EQ(cell.targets.size(), 1U);
            sum += cell.area;
        }
        EXPECT_NEAR(sum, 100.0, 40.0 * 1e-3);
        EXPECT_EQ(result.cells.size(), 4U);
    }
}

} // namespace
} // namespace tessera
