// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace tessera
{

/// Goes through the tags of an XML text one after the other; as much XML as VTK's files have.
/// Comments, declarations and what stands between tags are passed over. The text must outlive the
/// scanner and all views that it gives.
class XmlScanner
{
public:
    explicit XmlScanner(std::string_view text)
        : text_(text)
    {}

    /// Goes to the next tag. False at the end, or where the text is no XML: then failed().
    bool next();
    bool failed() const { return failed_; }

    /// "DataArray"; the same for <DataArray ...>, <DataArray ... /> and </DataArray>.
    std::string_view name() const { return name_; }
    bool isStart() const { return isStart_; } ///< also for a tag that ends itself
    bool isEnd() const { return isEnd_; }
    /// The attribute's text; empty if there is none.
    std::string_view attribute(std::string_view name) const;
    /// What follows the tag up to the next one.
    std::string_view content() const;
    /// Where the text goes on after the tag.
    std::size_t position() const { return at_; }

private:
    bool skipPast(std::string_view mark);
    void skipBlanks();
    std::string_view word();
    bool readTag();

    std::string_view text_;
    std::size_t at_ = 0;
    bool failed_ = false;
    std::string_view name_;
    bool isStart_ = false;
    bool isEnd_ = false;
    std::map<std::string_view, std::string_view> attributes_;
};

} // namespace tessera
