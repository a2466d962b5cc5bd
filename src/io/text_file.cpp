// SPDX-License-Identifier: MIT
#include "io/text_file.h"

#include "base/error.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace tessera
{

namespace
{

constexpr std::size_t kMostItems = 0xfffffffeU;

struct CloseFile
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void failToRead(const std::filesystem::path& path, const char* reason)
{
    throw Error(ErrorKind::Unreadable,
                fmt::format("{}: cannot be read: {}.", path.string(), reason));
}

std::unique_ptr<std::FILE, CloseFile> openToRead(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        failToRead(path, "it is a folder");
    }
    std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) {
        failToRead(path, std::strerror(errno));
    }
    return file;
}

} // namespace

void requireReadable(const std::filesystem::path& path)
{
    openToRead(path);
}

std::string readTextFile(const std::filesystem::path& path)
{
    const auto file = openToRead(path);
    std::error_code ignored;
    std::string text;
    const auto size = std::filesystem::file_size(path, ignored);
    if (!ignored) {
        text.reserve(size + 1);
    }
    char block[1 << 16];
    while (const std::size_t got = std::fread(block, 1, sizeof block, file.get())) {
        text.append(block, got);
    }
    if (std::ferror(file.get()) != 0) {
        failToRead(path, std::strerror(errno));
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // editors write it into UTF-8
    if (text.starts_with(kByteOrderMark)) {
        text.erase(0, kByteOrderMark.size());
    }
    return text;
}

void failAt(const std::string& file, std::size_t line, const std::string& what)
{
    // An empty file has no line.
    const std::string place = line == 0 ? file : fmt::format("{}:{}", file, line);
    throw Error(ErrorKind::Unreadable, fmt::format("{}: {}", place, what));
}

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    std::string shown = "'";
    for (char c : text.substr(0, kLongest)) {
        shown += c >= ' ' && c <= '~' ? c : '?';
    }
    return shown + (text.size() > kLongest ? "...'" : "'");
}

bool parseNumber(std::string_view word, double& value)
{
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) {
            return false;
        }
    }
    const char* end = word.data() + word.size();
    auto [stopped, error] = std::from_chars(word.data(), end, value);
    if (error == std::errc::result_out_of_range) {
        // Too small is a legitimate zero or subnormal number, too large is not.
        value = std::strtod(std::string(word).c_str(), nullptr);
        error = std::errc();
    }
    return error == std::errc() && stopped == end && std::isfinite(value);
}

bool parseNumber(std::string_view word, std::int64_t& value)
{
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) {
            return false;
        }
    }
    const char* end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && stopped == end;
}

bool LineReader::isSpace(char c) const
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == separator_;
}

bool LineReader::next()
{
    while (!rest_.empty()) {
        const std::size_t length = rest_.find('\n');
        current_ = rest_.substr(0, length);
        rest_.remove_prefix(length == std::string_view::npos ? rest_.size() : length + 1);
        ++line_;
        if (comment_ != '\0') {
            current_ = current_.substr(0, current_.find(comment_));
        }
        if (!atEnd()) {
            return true;
        }
    }
    current_ = {};
    return false;
}

void LineReader::need(const std::string& what)
{
    if (!next()) {
        fail(fmt::format("the file ends before {}; it may be cut off.", what));
    }
}

bool LineReader::atEnd()
{
    while (!current_.empty() && isSpace(current_.front())) {
        current_.remove_prefix(1);
    }
    return current_.empty();
}

std::string_view LineReader::word()
{
    atEnd();
    std::size_t length = 0;
    while (length < current_.size() && !isSpace(current_[length])) {
        ++length;
    }
    const std::string_view result = current_.substr(0, length);
    current_.remove_prefix(length);
    return result;
}

double LineReader::number(const char* name)
{
    const std::string_view field = word();
    double value = 0.0;
    if (field.empty()) {
        fail(fmt::format("the {} is missing.", name));
    }
    if (!parseNumber(field, value)) {
        fail(fmt::format("{} is not a finite number; expected the {}.", inQuotes(field), name));
    }
    return value;
}

std::int64_t LineReader::integer(const char* name)
{
    const std::string_view field = word();
    std::int64_t value = 0;
    if (field.empty()) {
        fail(fmt::format("the {} is missing.", name));
    }
    if (!parseNumber(field, value)) {
        fail(fmt::format("{} is not a whole number; expected the {}.", inQuotes(field), name));
    }
    return value;
}

std::size_t LineReader::count(const char* name)
{
    const std::int64_t value = integer(name);
    if (value < 0 || static_cast<std::uint64_t>(value) > kMostItems) {
        fail(fmt::format("the {} is {}; it must be 0 to {}.", name, value, kMostItems));
    }
    return static_cast<std::size_t>(value);
}

std::string_view LineReader::peekRest()
{
    atEnd();
    std::string_view result = current_;
    while (!result.empty() && isSpace(result.back())) {
        result.remove_suffix(1);
    }
    return result;
}

std::string_view LineReader::restOfLine()
{
    const std::string_view result = peekRest();
    current_ = {};
    return result;
}

} // namespace tessera
