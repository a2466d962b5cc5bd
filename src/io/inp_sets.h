// SPDX-License-Identifier: MIT
#pragma once

#include "io/raw_mesh_builder.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace tessera
{

/// The node and element sets of an input deck: only whether all that they name exists, since a
/// solver would drop the rest from a load or support.
class InpSets
{
public:
    /// A set that a keyword line defines, in capitals, such as "*NSET,NSET=A,GENERATE" or
    /// "*NODE,NSET=A"; members may follow.
    void define(const std::string& keyword);
    /// A line of members of the last set.
    void readMembers(LineReader& lines);
    /// Throws Error(Unreadable) for the first member, in the file's order, that does not exist.
    void requireMembers(const RawMeshBuilder& builder, const std::string& file) const;

private:
    struct Member
    {
        std::string set;          ///< of that name, if not empty
        std::int64_t number = 0;  ///< of a node or an element
        std::size_t line = 0;
        bool isElement = false;
    };

    std::set<std::string> nodeSets_;
    std::set<std::string> elementSets_;
    std::vector<Member> members_;
    bool isElement_ = false;
    bool isGenerated_ = false;
};

} // namespace tessera
