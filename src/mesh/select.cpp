// SPDX-License-Identifier: MIT
#include "mesh/select.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace tessera
{

namespace
{

constexpr int kDigitBits = 12;
using Counts = std::array<std::size_t, std::size_t {1} << kDigitBits>;

/// The order of non-negative floats is that of their bits.
std::uint32_t keyOf(float value)
{
    return std::bit_cast<std::uint32_t>(value);
}

/// Values by the digit below the given number of leading bits, of those that share these bits.
Counts countDigits(const ValuePieces& values, int leading, std::uint32_t prefix,
                   const Execution& execution)
{
    const int shift = std::max(32 - leading - kDigitBits, 0);
    const std::uint32_t mask = (1U << std::min(kDigitBits, 32 - leading)) - 1U;
    // Several pieces at once, because adding up the counts costs as much as counting a few thousand.
    const std::size_t together = values.size() / 16 + 1;
    std::vector<Counts> counts((values.size() + together - 1) / together);
    forEachPiece(execution, values.size(), together,
                 [&](std::size_t group, std::size_t begin, std::size_t end) {
                     Counts& own = counts[group];
                     own.fill(0);
                     for (std::size_t piece = begin; piece < end; ++piece) {
                         for (const float value : values[piece]) {
                             const std::uint32_t key = keyOf(value);
                             if (leading == 0 || key >> (32 - leading) == prefix) {
                                 ++own[(key >> shift) & mask];
                             }
                         }
                     }
                 });
    Counts sum {};
    for (const Counts& own : counts) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += own[i];
        }
    }
    return sum;
}

/// The value of the given rank among those that share leading bits.
class Selection
{
public:
    Selection(const ValuePieces& values, const Execution& execution)
        : values_(values)
        , execution_(execution)
    {}

    float at(std::size_t rank)
    {
        int leading = 0;
        std::uint32_t prefix = 0;
        for (int level = 0; leading < 32; ++level) {
            const Counts& counts = countsOf(level, leading, prefix);
            std::uint32_t digit = 0;
            for (; rank >= counts[digit]; ++digit) {
                rank -= counts[digit];
            }
            const int bits = std::min(kDigitBits, 32 - leading);
            prefix = prefix << bits | digit;
            leading += bits;
        }
        return std::bit_cast<float>(prefix);
    }

private:
    /// Neighboring percentiles often share their leading bits.
    const Counts& countsOf(int level, int leading, std::uint32_t prefix)
    {
        Level& found = levels_[static_cast<std::size_t>(level)];
        if (!found.known || found.prefix != prefix) {
            found = {true, prefix, countDigits(values_, leading, prefix, execution_)};
        }
        return found.counts;
    }

    struct Level
    {
        bool known = false;
        std::uint32_t prefix = 0;
        Counts counts {};
    };
    const ValuePieces& values_;
    const Execution& execution_;
    std::vector<Level> levels_ {3};
};

} // namespace

std::vector<float> percentiles(const ValuePieces& values, std::span<const double> fractions,
                               const Execution& execution)
{
    std::size_t count = 0;
    for (const auto& piece : values) {
        count += piece.size();
    }
    Selection selection(values, execution);
    std::vector<float> result;
    for (const double fraction : fractions) {
        result.push_back(
            selection.at(static_cast<std::size_t>(fraction * static_cast<double>(count - 1))));
    }
    return result;
}

} // namespace tessera
