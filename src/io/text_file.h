// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tessera
{

/// Throws Error(Unreadable) if the file cannot be opened for reading.
void requireReadable(const std::filesystem::path& path);

/// The whole file as text. Throws Error(Unreadable) if it cannot be opened or read.
std::string readTextFile(const std::filesystem::path& path);

/// "file:line: what", without a line if it is 0, thrown as Error(Unreadable).
[[noreturn]] void failAt(const std::string& file, std::size_t line, const std::string& what);

/// Text from a file as it may stand in a message: one line, printable, at most 40 characters.
std::string inQuotes(std::string_view text);

/// Parses all of a word as a finite double: any notation that C knows in decimal, a leading plus
/// allowed. Returns false if the word is something else, is nan or infinite, or overflows.
bool parseNumber(std::string_view word, double& value);
/// Parses all of a word as a whole number.
bool parseNumber(std::string_view word, std::int64_t& value);

/// Walks through the lines of a text and the fields of each line. Empty lines are passed over, and
/// what follows the comment character. Fields are separated by white space and by the extra
/// separator. The text must outlive the reader.
class LineReader
{
public:
    LineReader(std::string_view text, std::string file, char comment = '#', char separator = ' ')
        : rest_(text)
        , file_(std::move(file))
        , comment_(comment)
        , separator_(separator)
    {}

    /// Goes to the next line that has content; false at the end of the text.
    bool next();
    /// As next(), but fails with "<what> is missing" at the end of the text.
    void need(const std::string& what);

    /// No more fields in this line.
    bool atEnd();
    /// The next field; empty at the end of the line.
    std::string_view word();
    /// The next field as a number; fails with the field's name.
    double number(const char* name);
    std::int64_t integer(const char* name);
    /// A count: a whole number from 0 to 2^32 - 2.
    std::size_t count(const char* name);
    /// The rest of this line, without comment and outer white space; stays to be read.
    std::string_view peekRest();
    /// The same, and goes to its end.
    std::string_view restOfLine();

    const std::string& file() const { return file_; }
    std::size_t lineNumber() const { return line_; }
    /// Upper bound for the number of lines still to come, for reserving memory.
    std::size_t bytesLeft() const { return rest_.size(); }
    [[noreturn]] void fail(const std::string& what) const { failAt(file_, line_, what); }

private:
    bool isSpace(char c) const;

    std::string_view rest_;
    std::string_view current_;
    std::string file_;
    std::size_t line_ = 0;
    char comment_;
    char separator_;
};

} // namespace tessera
