// SPDX-License-Identifier: MIT
#include "io/group_names.h"

#include <set>

namespace tessera
{

namespace
{

constexpr std::size_t kLongestName = 80;

bool isLetter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

std::string plainName(std::string_view name)
{
    std::string plain = "G_";
    for (char c : name) {
        const bool keep = isLetter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
        const bool continues =
            (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; // of a UTF-8 letter
        if (!continues) {
            plain += keep ? c : '_';
        }
    }
    const bool startsWell = plain.size() > 2 && isLetter(plain[2]);
    return plain.substr(startsWell ? 2 : 0, kLongestName);
}

std::string inCapitals(std::string name)
{
    for (char& c : name) {
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return name;
}

} // namespace

std::vector<std::string> deckNames(const std::vector<std::string_view>& names,
                                   const std::vector<std::string_view>& reserved)
{
    std::set<std::string> taken;
    for (std::string_view name : reserved) {
        taken.insert(inCapitals(std::string(name)));
    }
    std::vector<std::string> result;
    for (std::string_view name : names) {
        const std::string plain = plainName(name);
        std::string unique = plain;
        for (int i = 2; !taken.insert(inCapitals(unique)).second; ++i) {
            std::string suffix(1, '_');
            suffix += std::to_string(i);
            unique = plain.substr(0, kLongestName - suffix.size()) + suffix;
        }
        result.push_back(unique);
    }
    return result;
}

} // namespace tessera
