// SPDX-License-Identifier: MIT
#include "vtk/vtu_data.h"

#include "io/text_file.h"
#include "vtk/error_listener.h"

#include <vtkDataCompressor.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace tessera
{

namespace
{

using Bytes = std::vector<unsigned char>;

[[noreturn]] void fail(const char* reason)
{
    throw std::string(reason);
}

int base64Value(char c)
{
    if (c >= 'A' && c <= 'Z') {
        return c - 'A';
    }
    if (c >= 'a' && c <= 'z') {
        return c - 'a' + 26;
    }
    if (c >= '0' && c <= '9') {
        return c - '0' + 52;
    }
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Where the bytes of an array come from, in order. A base64 text may be padded anywhere: lengths
/// and data are often encoded one after the other.
class ByteReader
{
public:
    ByteReader(std::string_view text, bool base64)
        : text_(text)
        , base64_(base64)
    {}

    void read(unsigned char* to, std::size_t count)
    {
        if (!base64_) {
            if (text_.size() < count) {
                fail("its data is cut off");
            }
            std::memcpy(to, text_.data(), count);
            text_.remove_prefix(count);
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (next_ == filled_) {
                fill();
            }
            to[i] = group_[next_++];
        }
    }
    /// Upper bound for the bytes still to come.
    std::size_t left() const { return text_.size() + 3; }

private:
    /// The next four characters, up to three bytes.
    void fill()
    {
        std::uint32_t bits = 0;
        int characters = 0;
        int padding = 0;
        while (characters < 4) {
            if (text_.empty()) {
                fail("its data is cut off");
            }
            const char c = text_.front();
            text_.remove_prefix(1);
            if (c == ' ' || (c >= '\t' && c <= '\r')) {
                continue;
            }
            const int value = c == '=' ? 0 : base64Value(c);
            if (value < 0 || (padding > 0 && c != '=')) {
                fail("its data is no base64 text");
            }
            padding += c == '=' ? 1 : 0;
            bits = bits << 6U | static_cast<std::uint32_t>(value);
            ++characters;
        }
        if (padding > 2) {
            fail("its data is no base64 text");
        }
        group_ = {static_cast<unsigned char>(bits >> 16U), static_cast<unsigned char>(bits >> 8U),
                  static_cast<unsigned char>(bits)};
        next_ = 0;
        filled_ = 3U - static_cast<std::size_t>(padding);
    }

    std::string_view text_;
    bool base64_;
    std::array<unsigned char, 3> group_ {};
    std::size_t next_ = 0;
    std::size_t filled_ = 0;
};

std::uint64_t readLength(ByteReader& bytes, const VtuEncoding& encoding)
{
    std::array<unsigned char, 8> raw {};
    bytes.read(raw.data(), encoding.headerBytes);
    if (encoding.swapBytes) {
        std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(encoding.headerBytes));
    }
    if (encoding.headerBytes == 4) {
        std::uint32_t value = 0;
        std::memcpy(&value, raw.data(), sizeof value);
        return value;
    }
    std::uint64_t value = 0;
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
}

vtkSmartPointer<vtkDataCompressor> makeCompressor(const std::string& name)
{
    if (name == "vtkZLibDataCompressor") {
        return vtkSmartPointer<vtkZLibDataCompressor>::New();
    }
    if (name == "vtkLZ4DataCompressor") {
        return vtkSmartPointer<vtkLZ4DataCompressor>::New();
    }
    if (name == "vtkLZMADataCompressor") {
        return vtkSmartPointer<vtkLZMADataCompressor>::New();
    }
    fail("its compressor is not known");
}

/// Number of blocks, their size, the size of the last one if it is another, the compressed sizes;
/// then the blocks.
Bytes readCompressed(ByteReader& bytes, const VtuEncoding& encoding, std::size_t size)
{
    const std::uint64_t blocks = readLength(bytes, encoding);
    const std::uint64_t blockSize = readLength(bytes, encoding);
    const std::uint64_t lastSize = readLength(bytes, encoding);
    const bool whole = lastSize == 0;
    const std::uint64_t fullBlocks = blocks - (whole || blocks == 0 ? 0 : 1);
    if (blocks > bytes.left() || lastSize > blockSize || (fullBlocks > 0 && blockSize > size)
        || fullBlocks * blockSize + (blocks == 0 ? 0 : lastSize) != size) {
        fail("its compressed blocks have not the size that it should have");
    }
    std::vector<std::uint64_t> lengths;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        lengths.push_back(readLength(bytes, encoding));
    }
    const auto compressor = makeCompressor(encoding.compressor);
    vtkNew<ErrorListener> listener;
    compressor->AddObserver(vtkCommand::ErrorEvent, listener);
    Bytes result(size);
    std::size_t at = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        if (lengths[b] > bytes.left()) {
            fail("its data is cut off");
        }
        Bytes packed(lengths[b]);
        bytes.read(packed.data(), packed.size());
        const std::size_t expected = b + 1 == blocks && !whole ? lastSize : blockSize;
        if (compressor->Uncompress(packed.data(), packed.size(), result.data() + at, expected)
                != expected
            || listener->failed()) {
            fail("its compressed data is damaged");
        }
        at += expected;
    }
    return result;
}

template<class Number>
void convert(const Bytes& bytes, std::vector<double>& values)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        Number number {};
        std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
        values[i] = static_cast<double>(number);
    }
}

void swapEach(Bytes& bytes, std::size_t size)
{
    for (auto at = bytes.begin(); at != bytes.end(); at += static_cast<std::ptrdiff_t>(size)) {
        std::reverse(at, at + static_cast<std::ptrdiff_t>(size));
    }
}

} // namespace

VtuType vtuType(std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, VtuType>, 10> kTypes {{
        {"Int8", VtuType::Int8},       {"UInt8", VtuType::UInt8},
        {"Int16", VtuType::Int16},     {"UInt16", VtuType::UInt16},
        {"Int32", VtuType::Int32},     {"UInt32", VtuType::UInt32},
        {"Int64", VtuType::Int64},     {"UInt64", VtuType::UInt64},
        {"Float32", VtuType::Float32}, {"Float64", VtuType::Float64},
    }};
    for (const auto& [known, type] : kTypes) {
        if (known == name) {
            return type;
        }
    }
    return VtuType::None;
}

std::size_t sizeOf(VtuType type)
{
    switch (type) {
        case VtuType::Int8:
        case VtuType::UInt8:
            return 1;
        case VtuType::Int16:
        case VtuType::UInt16:
            return 2;
        case VtuType::Int32:
        case VtuType::UInt32:
        case VtuType::Float32:
            return 4;
        case VtuType::Int64:
        case VtuType::UInt64:
        case VtuType::Float64:
            return 8;
        case VtuType::None:
            break;
    }
    return 0;
}

std::vector<double> decodeBinary(std::string_view text, const VtuEncoding& encoding, VtuType type,
                                 std::size_t count)
{
    // No compressor of VTK's reaches this ratio.
    constexpr std::size_t kGreatestRatio = 16384;
    const std::size_t possible = encoding.compressor.empty() ? text.size()
                                                             : kGreatestRatio * text.size();
    if (sizeOf(type) == 0) {
        fail("its number type is not known");
    }
    if (count > possible / sizeOf(type)) {
        fail("its data is cut off");
    }
    const std::size_t size = count * sizeOf(type);
    ByteReader reader(text, encoding.base64);
    Bytes bytes;
    if (encoding.compressor.empty()) {
        if (readLength(reader, encoding) != size) {
            fail("it has not the number of values that it should have");
        }
        bytes.resize(size);
        reader.read(bytes.data(), size);
    }
    else {
        bytes = readCompressed(reader, encoding, size);
    }
    if (encoding.swapBytes) {
        swapEach(bytes, sizeOf(type));
    }
    std::vector<double> values(count);
    switch (type) {
        case VtuType::Int8:
            convert<std::int8_t>(bytes, values);
            break;
        case VtuType::UInt8:
            convert<std::uint8_t>(bytes, values);
            break;
        case VtuType::Int16:
            convert<std::int16_t>(bytes, values);
            break;
        case VtuType::UInt16:
            convert<std::uint16_t>(bytes, values);
            break;
        case VtuType::Int32:
            convert<std::int32_t>(bytes, values);
            break;
        case VtuType::UInt32:
            convert<std::uint32_t>(bytes, values);
            break;
        case VtuType::Int64:
            convert<std::int64_t>(bytes, values);
            break;
        case VtuType::UInt64:
            convert<std::uint64_t>(bytes, values);
            break;
        case VtuType::Float32:
            convert<float>(bytes, values);
            break;
        case VtuType::Float64:
        case VtuType::None:
            convert<double>(bytes, values);
            break;
    }
    return values;
}

std::vector<double> decodeText(std::string_view text, std::size_t count)
{
    if (count > text.size()) {
        fail("it has not the number of values that it should have");
    }
    std::vector<double> values;
    values.reserve(count);
    std::size_t at = 0;
    const auto isBlank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    while (true) {
        while (at < text.size() && isBlank(text[at])) {
            ++at;
        }
        if (at == text.size()) {
            break;
        }
        std::size_t end = at;
        while (end < text.size() && !isBlank(text[end])) {
            ++end;
        }
        double value = 0.0;
        if (!parseNumber(text.substr(at, end - at), value)) {
            fail("it has something that is not a finite number");
        }
        values.push_back(value);
        at = end;
    }
    if (values.size() != count) {
        fail("it has not the number of values that it should have");
    }
    return values;
}

} // namespace tessera
