// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <gtest/gtest.h>

namespace tessera
{
namespace
{

TEST(NumberText, HasSixDigitsUnlessToldOtherwise)
{
    EXPECT_EQ(numberText(0.1 + 0.2), "0.3");
    EXPECT_EQ(numberText(-0.0), "0");
    EXPECT_EQ(numberText(1234567.0), "1.23457e+06");
    EXPECT_EQ(numberText(1234567.0, 7), "1234567");
}

TEST(PlaceText, HasFourDecimalsFarFromTheOrigin)
{
    EXPECT_EQ(placeText({0.1 + 0.2, -0.0}), "(0.3, 0)");
    EXPECT_EQ(placeText({1.0 / 3.0, 1e-70}), "(0.333333, 1e-70)");
    EXPECT_EQ(placeText({1000000.25, 3.0}), "(1000000.25, 3)");
    EXPECT_EQ(placeText({5000000.12344, -450000.5}), "(5000000.1234, -450000.5)");
    EXPECT_EQ(placeText({1e300, 0.0}), "(1.0000000000000001e+300, 0)");
}

TEST(PlaceText, TellsPlacesApart)
{
    for (const double at : {0.0, 1.0, 1e3, 1e6, 1e9}) {
        for (double apart = 1.0; apart > 4e-16 * at && apart > 1e-12; apart *= 0.3) {
            EXPECT_NE(placeText({at, 2.0}, apart), placeText({at + apart, 2.0}, apart));
            EXPECT_NE(placeText({2.0, -at}, apart), placeText({2.0, -at - apart}, apart));
        }
    }
}

} // namespace
} // namespace tessera
