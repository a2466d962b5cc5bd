// SPDX-License-Identifier: MIT

// Any bytes are an input: points and segments between them, triangulated, recovered by one of the
// strategies, verified. A finding is an invariant that does not hold, a sanitizer report or a hang.
//
// Byte 0: bit 0 the strategy, bits 1-2 the kind of coordinates (small integers; small integers
// divided by three; sixteen-bit fractions nudged by a few units in the last place; doubles as they
// are), bits 3-7 the number of points. Then the points, then segments as pairs of point numbers.

#include "base/error.h"
#include "delaunay/delaunay.h"
#include "recover/recover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace
{

using namespace tessera;

class Bytes
{
public:
    Bytes(const std::uint8_t* data, std::size_t size)
        : data_(data)
        , size_(size)
    {}
    bool empty() const { return size_ == 0; }
    template<class T>
    T take()
    {
        T value {};
        const std::size_t n = std::min(sizeof value, size_);
        std::memcpy(&value, data_, n);
        data_ += n;
        size_ -= n;
        return value;
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

double coordinate(Bytes& bytes, int kind)
{
    switch (kind) {
    case 0:
        return bytes.take<std::int8_t>() % 8;
    case 1:
        return bytes.take<std::int8_t>() % 16 / 3.0;
    case 2: {
        const double value = 1.0 + bytes.take<std::uint8_t>() / 256.0;
        return value + (bytes.take<std::int8_t>() % 4) * 0x1p-52;
    }
    default:
        return bytes.take<double>();
    }
}

void expectNone(const std::vector<std::string>& problems)
{
    if (!problems.empty()) {
        std::fprintf(stderr, "%s\n", problems.front().c_str());
        std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const auto head = bytes.take<std::uint8_t>();
    const int kind = (head >> 1) & 3;
    const std::size_t count = 2U + (head >> 3);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = coordinate(bytes, kind);
        points.push_back({x, coordinate(bytes, kind)});
    }
    Execution execution;
    try {
        DelaunayResult delaunay = triangulate(points, execution);
        expectNone(verify(delaunay.triangulation));
        std::vector<ConstraintEnds> ends;
        while (!bytes.empty() && ends.size() < 64) {
            const std::size_t a = bytes.take<std::uint8_t>() % count;
            const std::size_t b = bytes.take<std::uint8_t>() % count;
            ends.push_back({delaunay.vertexOfPoint[a], delaunay.vertexOfPoint[b]});
        }
        const std::vector<Vec2> input = delaunay.triangulation.points;
        const RecoveryResult result = recoverBoundaries(
            std::move(delaunay.triangulation), ends,
            (head & 1) != 0 ? RecoveryStrategy::Steiner : RecoveryStrategy::Cavity, execution);
        expectNone(verify(result.triangulation));
        expectNone(verifyConstraints(result, ends, input));
    }
    catch (const Error& error) {
        if (error.kind() != ErrorKind::InvalidInput) {
            throw;
        }
    }
    return 0;
}
