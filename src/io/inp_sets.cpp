// SPDX-License-Identifier: MIT
#include "io/inp_sets.h"

#include <algorithm>
#include <cctype>

namespace tessera
{

namespace
{

/// The value of a parameter in a keyword line; empty if it is not given.
std::string parameter(const std::string& keyword, const std::string& name)
{
    const std::size_t at = keyword.find("," + name + "=");
    if (at == std::string::npos) {
        return {};
    }
    const std::size_t begin = at + name.size() + 2;
    return keyword.substr(begin, keyword.find(',', begin) - begin);
}

std::string inCapitals(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) {
        return static_cast<char>(std::toupper(c));
    });
    return result;
}

} // namespace

void InpSets::define(const std::string& keyword)
{
    isElement_ = keyword.starts_with("*EL");
    isGenerated_ = keyword.find(",GENERATE") != std::string::npos;
    (isElement_ ? elementSets_ : nodeSets_).insert(parameter(keyword, isElement_ ? "ELSET" : "NSET"));
}

void InpSets::readMembers(LineReader& lines)
{
    // First, last and step of what is generated: the numbers between may have gaps.
    for (int i = 0; !lines.atEnd() && !(isGenerated_ && i == 2); ++i) {
        const std::string_view word = lines.word();
        Member member {{}, 0, lines.lineNumber(), isElement_};
        if (!parseNumber(word, member.number)) {
            member.set = inCapitals(word);
        }
        members_.push_back(std::move(member));
    }
}

void InpSets::requireMembers(const RawMeshBuilder& builder, const std::string& file) const
{
    std::vector<std::int64_t> elements;
    if (!members_.empty()) {
        for (const RawMesh::Cell& cell : builder.mesh().cells) {
            elements.push_back(cell.number);
        }
        std::ranges::sort(elements);
    }
    for (const Member& member : members_) {
        const char* kind = member.isElement ? "element" : "node";
        if (!member.set.empty()) {
            if (!(member.isElement ? elementSets_ : nodeSets_).contains(member.set)) {
                failAt(file, member.line,
                       fmt::format("there is no {} set {}.", kind, inQuotes(member.set)));
            }
        }
        else if (member.isElement ? !std::ranges::binary_search(elements, member.number)
                                  : !builder.hasNode(member.number)) {
            failAt(file, member.line,
                   fmt::format("the set names {} {}, which does not exist; the file is cut off or "
                               "its sets belong to another mesh.",
                               kind, member.number));
        }
    }
}

} // namespace tessera
