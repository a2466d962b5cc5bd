// SPDX-License-Identifier: MIT
#pragma once

// Expansion arithmetic after J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
// Robust Geometric Predicates", Discrete & Computational Geometry 18 (1997).
//
// An expansion is an unevaluated sum of doubles that do not overlap, ordered by increasing
// magnitude: it holds sums, differences and products of doubles without any rounding.
//
// Guarantee: every operation is exact as long as no intermediate product overflows or falls below
// 2^-1074, that is for factors whose magnitudes and lowest set bits keep the result's within
// 2^-1074 .. 2^1000. Round to nearest even; no contraction (-ffp-contract=off).
// Cost: sums are linear, products of n and m components O(n m min(n, m)).

#include <cstddef>
#include <utility>

namespace tessera
{

/// A rounded result and what the rounding dropped: head + tail is exact.
struct TwoPart
{
    double head;
    double tail;
};

/// Exact sum.
constexpr TwoPart twoSum(double a, double b)
{
    const double head = a + b;
    const double bVirtual = head - a;
    const double aVirtual = head - bVirtual;
    return {head, (a - aVirtual) + (b - bVirtual)};
}

/// Exact sum, given |a| >= |b| (or a == 0).
constexpr TwoPart fastTwoSum(double a, double b)
{
    const double head = a + b;
    return {head, b - (head - a)};
}

/// Exact difference.
constexpr TwoPart twoDifference(double a, double b)
{
    return twoSum(a, -b);
}

/// Dekker's split: head and tail have at most 26 bits each.
constexpr TwoPart split(double a)
{
    constexpr double kSplitter = 134217729.0; // 2^27 + 1
    const double c = kSplitter * a;
    const double head = c - (c - a);
    return {head, a - head};
}

/// Exact product with b already split.
constexpr TwoPart twoProduct(double a, double b, TwoPart bSplit)
{
    const double head = a * b;
    const TwoPart aSplit = split(a);
    const double error1 = head - aSplit.head * bSplit.head;
    const double error2 = error1 - aSplit.tail * bSplit.head;
    const double error3 = error2 - aSplit.head * bSplit.tail;
    return {head, aSplit.tail * bSplit.tail - error3};
}

/// Exact product.
constexpr TwoPart twoProduct(double a, double b)
{
    return twoProduct(a, b, split(b));
}

/// Expansion sum: out = a + sign * b, merged by magnitude and carried upward; zeros are dropped.
/// out has room for n + m components and overlaps neither operand. Returns the size of out.
constexpr std::size_t sumExpansions(const double* a, std::size_t n, const double* b, std::size_t m,
                                    double sign, double* out)
{
    const auto magnitude = [](double x) { return x < 0.0 ? -x : x; };
    std::size_t i = 0;
    std::size_t j = 0;
    const auto smallest = [&] {
        const bool fromA = j == m || (i < n && magnitude(a[i]) <= magnitude(b[j]));
        return fromA ? a[i++] : sign * b[j++];
    };
    std::size_t size = 0;
    double carry = 0.0;
    for (std::size_t k = 0; k < n + m; ++k) {
        const TwoPart sum = twoSum(carry, smallest());
        if (sum.tail != 0.0) {
            out[size++] = sum.tail;
        }
        carry = sum.head;
    }
    if (carry != 0.0) {
        out[size++] = carry;
    }
    return size;
}

/// out = a * b; out has room for 2 n components and does not overlap a. Returns the size of out.
constexpr std::size_t scaleExpansion(const double* a, std::size_t n, double b, double* out)
{
    const TwoPart bSplit = split(b);
    std::size_t size = 0;
    double carry = 0.0;
    const auto append = [&](double component) {
        if (component != 0.0) {
            out[size++] = component;
        }
    };
    for (std::size_t i = 0; i < n; ++i) {
        const TwoPart product = twoProduct(a[i], b, bSplit);
        const TwoPart sum = twoSum(carry, product.tail);
        append(sum.tail);
        const TwoPart next = fastTwoSum(product.head, sum.head);
        append(next.tail);
        carry = next.head;
    }
    append(carry);
    return size;
}

/// An exact number of at most Capacity components; zero components are dropped.
template<std::size_t Capacity>
class Expansion
{
public:
    constexpr Expansion() {} // NOLINT: the components behind size() are not initialized on purpose
    constexpr Expansion(double value)
    {
        append(value);
    }
    constexpr Expansion(TwoPart value)
        requires(Capacity >= 2)
    {
        append(value.tail);
        append(value.head);
    }

    constexpr std::size_t size() const { return size_; }
    constexpr double operator[](std::size_t i) const { return components_[i]; }

    /// -1, 0 or 1.
    constexpr int sign() const
    {
        if (size_ == 0) {
            return 0;
        }
        return components_[size_ - 1] > 0.0 ? 1 : -1;
    }
    /// The value with a relative error of at most 2^-52.
    constexpr double estimate() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < size_; ++i) {
            sum += components_[i];
        }
        return sum;
    }
    constexpr Expansion operator-() const
    {
        Expansion result;
        result.size_ = size_;
        for (std::size_t i = 0; i < size_; ++i) {
            result.components_[i] = -components_[i];
        }
        return result;
    }
    /// Takes a component of greater magnitude than all before it, not overlapping them.
    constexpr void append(double component)
    {
        if (component != 0.0) {
            components_[size_++] = component;
        }
    }
    /// For the operations below: they write the components and say how many there are.
    constexpr const double* data() const { return components_; }
    constexpr double* data() { return components_; }
    constexpr void setSize(std::size_t size) { size_ = size; }

private:
    double components_[Capacity];
    std::size_t size_ = 0;
};

template<std::size_t N, std::size_t M>
constexpr Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b)
{
    Expansion<N + M> result;
    result.setSize(sumExpansions(a.data(), a.size(), b.data(), b.size(), 1.0, result.data()));
    return result;
}

template<std::size_t N, std::size_t M>
constexpr Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b)
{
    Expansion<N + M> result;
    result.setSize(sumExpansions(a.data(), a.size(), b.data(), b.size(), -1.0, result.data()));
    return result;
}

template<std::size_t N>
constexpr Expansion<2 * N> operator*(const Expansion<N>& a, double b)
{
    Expansion<2 * N> result;
    result.setSize(scaleExpansion(a.data(), a.size(), b, result.data()));
    return result;
}

/// Sum of the rows a * b[j], from two buffers in turn.
template<std::size_t N, std::size_t M>
constexpr Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b)
{
    if constexpr (N < M) {
        return b * a;
    }
    else {
        Expansion<2 * N * M> sum;
        Expansion<2 * N * M> previous;
        Expansion<2 * N> row;
        double* from = previous.data();
        double* to = sum.data();
        std::size_t size = 0;
        for (std::size_t j = 0; j < b.size(); ++j) {
            row.setSize(scaleExpansion(a.data(), a.size(), b[j], row.data()));
            size = sumExpansions(from, size, row.data(), row.size(), 1.0, to);
            std::swap(from, to);
        }
        // The result is where the last row was added: `from` after the swap.
        Expansion<2 * N * M>& result = from == sum.data() ? sum : previous;
        result.setSize(size);
        return result;
    }
}

} // namespace tessera
