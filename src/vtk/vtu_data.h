// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tessera
{

/// How the binary data of a VTK XML file is written.
struct VtuEncoding
{
    bool base64 = false;
    bool swapBytes = false;      ///< the file's byte order is not this machine's
    std::size_t headerBytes = 4; ///< size of the lengths before the data: 4 or 8
    std::string compressor;      ///< class name; empty: not compressed
};

/// Number types of data arrays; None for an unknown name.
enum class VtuType : std::uint8_t
{
    None,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64,
};
VtuType vtuType(std::string_view name);
std::size_t sizeOf(VtuType type);

/// The data array that starts at the beginning of text, which may go on behind it, as numbers. Each
/// throws std::string, the reason as a part of a sentence, if the data is damaged or has another
/// number of values; nothing in the data is believed, and no more memory is taken than count needs.
std::vector<double> decodeBinary(std::string_view text, const VtuEncoding& encoding, VtuType type,
                                 std::size_t count);
std::vector<double> decodeText(std::string_view text, std::size_t count);

} // namespace tessera
