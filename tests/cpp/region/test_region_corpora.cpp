// SPDX-License-Identifier: MIT

// Colors of every planar straight-line graph of the corpora: the bounded faces and their area
// against exact arithmetic and GEOS, and the even-odd inside of triangles against counting
// crossings of rays.

#include "io/read_poly.h"
#include "property/corpora.h"
#include "region/colored.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace tessera
{
namespace
{

class RegionCorpora: public testing::Test
{
protected:
    void SetUp() override
    {
        TESSERA_NEEDS_CORPORA();
        cases_ = test::corpusPslgs();
        manifest_ = nlohmann::json::parse(readTextFile(test::corpora() / "MANIFEST.json"));
    }
    std::vector<test::CorpusPslg> cases_;
    nlohmann::json manifest_;
};

CurveNetwork readCase(const test::CorpusPslg& c)
{
    return parsePoly(test::readPacked(test::corpora() / c.name), c.name);
}

TEST_F(RegionCorpora, AllKeepsTheBoundedFacesOfTheExactArrangement)
{
    for (const test::CorpusPslg& c : cases_) {
        if (!c.wellConditioned) {
            continue;
        }
        SCOPED_TRACE(c.name);
        const Colored colored = color(readCase(c), FillRule::All);
        EXPECT_EQ(colored.map.keptRegions, c.exact.faces);
        const auto& expect = manifest_.at(c.name).at("expect");
        if (expect.contains("geos") && expect.value("geos_agrees", false)) {
            const double area = expect.at("geos").at("area");
            EXPECT_NEAR(colored.areaInside(), area, 1e-9 * area);
        }
    }
}

TEST_F(RegionCorpora, BothStrategiesNumberTheSameRegions)
{
    std::size_t compared = 0;
    for (const test::CorpusPslg& c : cases_) {
        SCOPED_TRACE(c.name);
        const CurveNetwork network = readCase(c);
        const RegionMap cavity = color(network, FillRule::All).map;
        const RegionMap steiner =
            color(network, FillRule::All, 1e9, false, RecoveryStrategy::Steiner).map;
        ASSERT_EQ(cavity.regions.size(), steiner.regions.size());
        for (std::size_t r = 1; r < cavity.regions.size(); ++r) {
            const double area = cavity.regions[r].area;
            ASSERT_NEAR(area, steiner.regions[r].area, 1e-9 * area) << "region " << r;
            ASSERT_EQ(cavity.regions[r].operands, steiner.regions[r].operands);
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000U);
}

/// Crossings of the ray from p to the right with what the network's roles say is boundary.
bool insideByParity(const CurveNetwork& network, Vec2 p)
{
    bool inside = false;
    for (const NetworkCurve& curve : network.curves) {
        if (curve.role != Role::Boundary) {
            continue;
        }
        const Vec2 a = network.points[curve.start.index()];
        const Vec2 b = network.points[curve.end.index()];
        if ((a.y <= p.y) != (b.y <= p.y)) {
            const bool right = (cross(b - a, p - a) > 0.0) == (b.y > a.y);
            inside = inside != right;
        }
    }
    return inside;
}

TEST_F(RegionCorpora, EvenOddAgreesWithCountingRaysWhereAllLoopsClose)
{
    std::size_t checked = 0;
    for (const test::CorpusPslg& c : cases_) {
        CurveNetwork network = readCase(c);
        network.holes.clear();
        const bool outlines =
            std::any_of(network.curves.begin(), network.curves.end(),
                        [](const NetworkCurve& curve) { return curve.role == Role::Outline; });
        if (outlines) {
            continue;
        }
        SCOPED_TRACE(c.name);
        const Colored colored = color(network, FillRule::EvenOdd);
        const Triangulation& t = colored.recovered.triangulation;
        double greatest = 0.0;
        for (const Vec2 p : colored.network.points) {
            greatest = std::max({greatest, std::abs(p.x), std::abs(p.y)});
        }
        const std::size_t step = 1 + t.triangles.size() / 200;
        for (std::uint32_t i = 0; i < t.triangles.size(); i += step) {
            if (!t.isFinite(i)) {
                continue;
            }
            const auto& v = t.triangles[i].v;
            const Vec2 center =
                (1.0 / 3.0) * (t.points[v[0]] + t.points[v[1]] + t.points[v[2]]);
            const double twiceArea =
                cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]);
            if (twiceArea < 1e-9 * greatest * greatest) {
                continue; // too thin for rounded rays
            }
            const RegionId region = colored.map.regionOfTriangle[i];
            EXPECT_EQ(colored.map.regions[region.index()].inside,
                      insideByParity(colored.network, center));
            ++checked;
        }
    }
    EXPECT_GT(checked, 5000U);
}

} // namespace
} // namespace tessera
