// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace tessera::fuzz
{

/// A fuzzer's input, taken apart from its beginning; zeros when it is used up.
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
        if (n > 0) {
            std::memcpy(&value, data_, n);
        }
        data_ += n;
        size_ -= n;
        return value;
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

inline std::string_view asText(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// A finding.
[[noreturn]] inline void fail(const std::string& what)
{
    std::fprintf(stderr, "%s\n", what.c_str());
    std::abort();
}

inline void require(bool condition, const char* what)
{
    if (!condition) {
        fail(what);
    }
}

} // namespace tessera::fuzz
