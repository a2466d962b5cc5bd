// SPDX-License-Identifier: MIT

#include "base/huge_pages.h"

#include <gtest/gtest.h>

#include <numeric>

namespace tessera
{
namespace
{

TEST(HugePages, AnArrayKeepsWhatItHolds)
{
    std::vector<int> array(1000);
    std::iota(array.begin(), array.end(), 0);
    const std::size_t large = std::size_t {3} << 20;
    reserveOnHugePages(array, large);
    EXPECT_GE(array.capacity(), large);
    ASSERT_EQ(array.size(), 1000);
    array.resize(large, -1);
    // Again, now that its pages are in use.
    preferHugePages(array.data(), array.size() * sizeof(int));
    for (std::size_t i = 0; i < large; ++i) {
        ASSERT_EQ(array[i], i < 1000 ? static_cast<int>(i) : -1);
    }
}

TEST(HugePages, SmallAndEmptyArraysAreLeftAlone)
{
    std::vector<int> none;
    reserveOnHugePages(none, 0);
    EXPECT_TRUE(none.empty());
    preferHugePages(nullptr, 0);
    std::vector<int> few {1, 2, 3};
    preferHugePages(few.data(), few.size() * sizeof(int));
    EXPECT_EQ(few, (std::vector<int> {1, 2, 3}));
}

} // namespace
} // namespace tessera
