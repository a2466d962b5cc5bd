// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "expression/expression_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

namespace tessera
{
namespace
{

TEST(Expression, GivesWhatItSays)
{
    const struct
    {
        const char* text;
        std::function<double(Vec2)> expected;
    } cases[] {
        {"2.5", [](Vec2) { return 2.5; }},
        {"1 + 0.1*x", [](Vec2 p) { return 1 + 0.1 * p.x; }},
        {"sqrt(x^2 + y^2)", [](Vec2 p) { return std::sqrt(p.x * p.x + p.y * p.y); }},
        {"min(3, max(x, y))", [](Vec2 p) { return std::min(3.0, std::max(p.x, p.y)); }},
        {"x < y ? 1 : 2", [](Vec2 p) { return p.x < p.y ? 1.0 : 2.0; }},
        {"2 - cos(pi*x)*exp(-y)",
         [](Vec2 p) { return 2 - std::cos(std::acos(-1.0) * p.x) * std::exp(-p.y); }},
        {"1e-3 + abs(x)", [](Vec2 p) { return 1e-3 + std::abs(p.x); }},
    };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-5.0, 5.0);
    for (const auto& c : cases) {
        const AreaSource source = expressionSource(c.text);
        EXPECT_TRUE(source.asksEverywhere);
        for (int i = 0; i < 100; ++i) {
            const Vec2 p {uniform(random), uniform(random)};
            const double expected = c.expected(p);
            EXPECT_NEAR(source.size(p), expected, 1e-12 * (1 + std::abs(expected))) << c.text;
        }
    }
}

TEST(Expression, IsRefusedInPlainWords)
{
    for (const std::string bad :
         {"", "  ", "1 +", "x + z", "1,5", "sin(", ")", "1 2", "foo(x)", "\"text\"", "x ? 1",
          "1e999999", "=", "\n"}) {
        try {
            const AreaSource source = expressionSource(bad);
            // Infinite numbers are found where the field is made, with the place.
            EXPECT_TRUE(std::isinf(source.size({1, 1}))) << bad;
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidOption);
            EXPECT_NE(std::string(error.what()).find("size expression"), std::string::npos);
            EXPECT_EQ(std::string(error.what()).back(), '.');
        }
    }
    EXPECT_THROW(expressionSource(std::string(5000, '1')), Error);
    EXPECT_THROW(expressionSource(std::string(3000, '(') + "1"), Error);
}

TEST(Expression, NothingIsAssigned)
{
    for (const std::string text : {"y=2", "x = 2", "y==2 ? 1 : y=3", "pi=3", "=1", "x=", "x=y=2",
                                   "(x)=2", "x<=y ? x=1 : 2", "x= =2"}) {
        try {
            expressionSource(text);
            FAIL() << text;
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidOption);
            EXPECT_NE(std::string(error.what()).find("did you mean ==?"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_EQ(expressionSource("x<=1 && x>=1 && x!=2 && x==1 ? 3 : 4").size({1, 0}), 3.0);
}

TEST(Expression, NamesTheWayToWriteWhatOthersWriteDifferently)
{
    const struct
    {
        const char* text;
        const char* hint;
    } cases[] {
        {"x**2", "write ^"},
        {"if(x<5,1,2)", "condition ? size : other size"},
        {"1 if x<5 else 2", "condition ? size : other size"},
        {"x<5 ? 1", "condition ? size : other size"},
        {"1,5", "write a decimal point"},
    };
    for (const auto& c : cases) {
        try {
            expressionSource(c.text);
            FAIL() << c.text;
        }
        catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(c.hint), std::string::npos) << error.what();
        }
    }
}

TEST(Expression, NumbersThatAreNoneHaveNoSign)
{
    const double value = expressionSource("sqrt(x)").size({-1, 0});
    EXPECT_TRUE(std::isnan(value));
    EXPECT_FALSE(std::signbit(value));
}

TEST(Expression, SourcesDoNotShareTheirVariables)
{
    const AreaSource a = expressionSource("x");
    const AreaSource b = expressionSource("x + y");
    EXPECT_EQ(a.size({1, 2}), 1.0);
    EXPECT_EQ(b.size({3, 4}), 7.0);
    EXPECT_EQ(a.size({5, 6}), 5.0);
}

TEST(Expression, NamesThePlaceWhereItIsNotPositive)
{
    Execution execution;
    const std::vector<AreaSource> sources {expressionSource("x - 5")};
    try {
        const AreaSize field({{0, 0}, {10, 10}}, sources, {.maxSize = 2.0}, execution);
        FAIL() << "accepted";
    }
    catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("The size expression 'x - 5' is -"),
                  std::string::npos)
            << error.what();
        EXPECT_LT(error.places().at(0).position.x, 5.0);
    }
}

} // namespace
} // namespace tessera
