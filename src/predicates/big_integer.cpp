// SPDX-License-Identifier: MIT
#include "predicates/big_integer.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace tessera::exact
{

BigInteger::BigInteger(double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto biased = static_cast<std::uint32_t>((bits >> 52) & 0x7ff);
    const std::uint64_t fraction = bits & 0xfffffffffffffULL;
    const std::uint64_t mantissa = biased == 0 ? fraction : fraction | 0x10000000000000ULL;
    const std::uint32_t shift = biased == 0 ? 0 : biased - 1;
    const std::uint32_t inLimb = shift % 32;
    negative_ = (bits >> 63) != 0;
    limbs_.assign(shift / 32, 0U);
    limbs_.push_back(static_cast<std::uint32_t>(mantissa << inLimb));
    limbs_.push_back(static_cast<std::uint32_t>((mantissa << inLimb) >> 32));
    limbs_.push_back(inLimb == 0 ? 0U : static_cast<std::uint32_t>(mantissa >> (64 - inLimb)));
    trim();
}

void BigInteger::trim()
{
    while (!limbs_.empty() && limbs_.back() == 0) {
        limbs_.pop_back();
    }
    negative_ = negative_ && !limbs_.empty();
}

int BigInteger::compareMagnitudes(const Limbs& a, const Limbs& b)
{
    if (a.size() != b.size()) {
        return a.size() > b.size() ? 1 : -1;
    }
    for (std::size_t i = a.size(); i-- > 0;) {
        if (a[i] != b[i]) {
            return a[i] > b[i] ? 1 : -1;
        }
    }
    return 0;
}

BigInteger::Limbs BigInteger::addMagnitudes(const Limbs& a, const Limbs& b)
{
    const Limbs& longer = a.size() >= b.size() ? a : b;
    const Limbs& shorter = a.size() >= b.size() ? b : a;
    Limbs sum;
    sum.reserve(longer.size() + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < longer.size(); ++i) {
        carry += longer[i];
        carry += i < shorter.size() ? shorter[i] : 0U;
        sum.push_back(static_cast<std::uint32_t>(carry));
        carry >>= 32;
    }
    sum.push_back(static_cast<std::uint32_t>(carry));
    return sum;
}

BigInteger::Limbs BigInteger::subtractMagnitudes(const Limbs& greater, const Limbs& less)
{
    Limbs difference;
    difference.reserve(greater.size());
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < greater.size(); ++i) {
        std::int64_t digit = borrow + greater[i] - (i < less.size() ? less[i] : 0U);
        borrow = digit < 0 ? -1 : 0;
        digit += digit < 0 ? (std::int64_t {1} << 32) : 0;
        difference.push_back(static_cast<std::uint32_t>(digit));
    }
    return difference;
}

BigInteger BigInteger::operator-() const
{
    BigInteger result = *this;
    result.negative_ = !negative_ && !limbs_.empty();
    return result;
}

BigInteger operator+(const BigInteger& a, const BigInteger& b)
{
    BigInteger result;
    if (a.negative_ == b.negative_) {
        result.limbs_ = BigInteger::addMagnitudes(a.limbs_, b.limbs_);
        result.negative_ = a.negative_;
    }
    else if (BigInteger::compareMagnitudes(a.limbs_, b.limbs_) >= 0) {
        result.limbs_ = BigInteger::subtractMagnitudes(a.limbs_, b.limbs_);
        result.negative_ = a.negative_;
    }
    else {
        result.limbs_ = BigInteger::subtractMagnitudes(b.limbs_, a.limbs_);
        result.negative_ = b.negative_;
    }
    result.trim();
    return result;
}

BigInteger operator*(const BigInteger& a, const BigInteger& b)
{
    BigInteger result;
    result.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0U);
    for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
            carry += result.limbs_[i + j]
                + static_cast<std::uint64_t>(a.limbs_[i]) * b.limbs_[j];
            result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        result.limbs_[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
    }
    result.negative_ = a.negative_ != b.negative_;
    result.trim();
    return result;
}

} // namespace tessera::exact
