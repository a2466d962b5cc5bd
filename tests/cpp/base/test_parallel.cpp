// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace
{

using namespace tessera;

Execution& withThreads(Execution& execution, int threads)
{
    execution.setThreads(threads);
    return execution;
}

TEST(Parallel, EveryPieceOnceAndTheSameForAnyNumberOfThreads)
{
    for (const int threads : {1, 2, 7}) {
        Execution execution;
        withThreads(execution, threads);
        for (const std::size_t count : {0U, 1U, 9U, 10U, 11U, 1000U}) {
            std::vector<int> seen(count, 0);
            std::vector<std::size_t> begins((count + 9) / 10, 0);
            forEachPiece(execution, count, 10,
                         [&](std::size_t piece, std::size_t begin, std::size_t end) {
                             begins[piece] = begin;
                             for (std::size_t i = begin; i < end; ++i) {
                                 ++seen[i];
                             }
                         });
            EXPECT_EQ(seen, std::vector<int>(count, 1));
            for (std::size_t piece = 0; piece < begins.size(); ++piece) {
                EXPECT_EQ(begins[piece], 10 * piece);
            }
        }
    }
}

TEST(Parallel, CollectsInOrder)
{
    std::vector<std::size_t> expected(10000);
    std::iota(expected.begin(), expected.end(), std::size_t {0});
    for (const int threads : {1, 3}) {
        Execution execution;
        const auto all = collectPieces<std::size_t>(
            withThreads(execution, threads), expected.size(), 7,
            [](std::size_t begin, std::size_t end, std::vector<std::size_t>& part) {
                for (std::size_t i = begin; i < end; ++i) {
                    part.push_back(i);
                }
            });
        EXPECT_EQ(all, expected);
    }
}

TEST(Parallel, ThrowsOnWhatAPieceThrowsAndWorksAgainAfterwards)
{
    Execution execution;
    withThreads(execution, 2);
    for (int i = 0; i < 100; ++i) {
        EXPECT_THROW(forEachPiece(execution, 50, 1,
                                  [](std::size_t piece, std::size_t, std::size_t) {
                                      if (piece == 20) {
                                          throw std::runtime_error("piece 20");
                                      }
                                  }),
                     std::runtime_error);
        int sum[2] = {0, 0};
        runTogether(execution, [&] { sum[0] = 1; }, [&] { sum[1] = 2; });
        EXPECT_EQ(sum[0] + sum[1], 3);
    }
}

/// Jobs that end before the other threads wake up, one right after the other.
TEST(Parallel, ManyShortJobs)
{
    Execution execution;
    withThreads(execution, 4);
    std::size_t sum = 0;
    for (int i = 0; i < 5000; ++i) {
        std::size_t part[4] = {};
        forEachPiece(execution, 4, 1, [&](std::size_t piece, std::size_t, std::size_t) {
            part[piece] = piece + 1;
        });
        sum += part[0] + part[1] + part[2] + part[3];
    }
    EXPECT_EQ(sum, 50000U);
}

TEST(Parallel, TouchesWithoutChangingValues)
{
    Execution execution;
    withThreads(execution, 2);
    std::vector<int> values {1, 2, 3};
    reserveTouched(execution, values, 1 << 20);
    EXPECT_GE(values.capacity(), std::size_t {1} << 20);
    EXPECT_EQ(values, (std::vector<int> {1, 2, 3}));
}

} // namespace
