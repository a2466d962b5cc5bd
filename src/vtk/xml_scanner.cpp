// SPDX-License-Identifier: MIT
#include "vtk/xml_scanner.h"

namespace tessera
{

namespace
{

bool isBlank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool endsWord(char c)
{
    return isBlank(c) || c == '<' || c == '>' || c == '/' || c == '=' || c == '"' || c == '\'';
}

} // namespace

bool XmlScanner::next()
{
    while (!failed_) {
        at_ = text_.find('<', at_);
        if (at_ == std::string_view::npos) {
            at_ = text_.size();
            return false;
        }
        const std::string_view rest = text_.substr(at_);
        if (rest.starts_with("<!--")) {
            failed_ = !skipPast("-->");
        }
        else if (rest.starts_with("<?") || rest.starts_with("<!")) {
            failed_ = !skipPast(">");
        }
        else {
            ++at_;
            failed_ = !readTag();
            return !failed_;
        }
    }
    return false;
}

std::string_view XmlScanner::attribute(std::string_view name) const
{
    const auto found = attributes_.find(name);
    return found == attributes_.end() ? std::string_view() : found->second;
}

std::string_view XmlScanner::content() const
{
    return text_.substr(at_, text_.find('<', at_) - at_);
}

bool XmlScanner::skipPast(std::string_view mark)
{
    const std::size_t found = text_.find(mark, at_);
    if (found == std::string_view::npos) {
        return false;
    }
    at_ = found + mark.size();
    return true;
}

void XmlScanner::skipBlanks()
{
    while (at_ < text_.size() && isBlank(text_[at_])) {
        ++at_;
    }
}

std::string_view XmlScanner::word()
{
    const std::size_t start = at_;
    while (at_ < text_.size() && !endsWord(text_[at_])) {
        ++at_;
    }
    return text_.substr(start, at_ - start);
}

/// Behind the '<'.
bool XmlScanner::readTag()
{
    attributes_.clear();
    isEnd_ = at_ < text_.size() && text_[at_] == '/';
    isStart_ = !isEnd_;
    at_ += isEnd_ ? 1 : 0;
    name_ = word();
    if (name_.empty()) {
        return false;
    }
    for (skipBlanks(); at_ < text_.size(); skipBlanks()) {
        if (text_[at_] == '>') {
            ++at_;
            return true;
        }
        if (text_[at_] == '/') {
            isEnd_ = true;
            ++at_;
            continue;
        }
        const std::string_view key = word();
        skipBlanks();
        if (key.empty() || at_ >= text_.size() || text_[at_] != '=') {
            return false;
        }
        ++at_;
        skipBlanks();
        const char quote = at_ < text_.size() ? text_[at_] : '\0';
        const std::size_t end = text_.find(quote, at_ + 1);
        if ((quote != '"' && quote != '\'') || end == std::string_view::npos) {
            return false;
        }
        attributes_[key] = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
    }
    return false;
}

} // namespace tessera
