// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace tessera
{

/// Text put together fast: numbers are appended in their shortest form that reads back equal.
class TextBuilder
{
public:
    TextBuilder& operator<<(std::string_view text)
    {
        text_ += text;
        return *this;
    }
    TextBuilder& operator<<(char c)
    {
        text_ += c;
        return *this;
    }
    template<class Number>
        requires(std::integral<Number> || std::floating_point<Number>)
    TextBuilder& operator<<(Number value)
    {
        char digits[32];
        const auto result = std::to_chars(digits, digits + sizeof digits, value);
        text_.append(digits, static_cast<std::size_t>(result.ptr - digits));
        return *this;
    }

    void reserve(std::size_t bytes) { text_.reserve(bytes); }
    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

} // namespace tessera
