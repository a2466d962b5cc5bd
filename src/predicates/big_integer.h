// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace tessera::exact
{

/// Integer of any size, the last resort of the predicates. Schoolbook arithmetic: it is reached
/// only by coordinates more than 1e140 apart in magnitude.
class BigInteger
{
public:
    BigInteger() = default;
    /// value * 2^1074, which is an integer for every finite double.
    explicit BigInteger(double value);

    /// -1, 0 or 1.
    int sign() const { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }

    BigInteger operator-() const;
    friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
    friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + -b; }
    friend BigInteger operator*(const BigInteger& a, const BigInteger& b);

private:
    using Limbs = std::vector<std::uint32_t>; ///< least first, none leading is zero

    static int compareMagnitudes(const Limbs& a, const Limbs& b);
    static Limbs addMagnitudes(const Limbs& a, const Limbs& b);
    static Limbs subtractMagnitudes(const Limbs& greater, const Limbs& less);
    void trim();

    Limbs limbs_;
    bool negative_ = false;
};

} // namespace tessera::exact
