// SPDX-License-Identifier: MIT
#include "io/read_wkt.h"

#include "io/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tessera
{

namespace
{

enum class WktType
{
    Point,
    LineString,
    Polygon,
    MultiPoint,
    MultiLineString,
    MultiPolygon,
    Collection,
};

struct TypeName
{
    std::string_view name;
    WktType type;
};
constexpr std::array<TypeName, 8> kTypes {{
    {"POINT", WktType::Point},
    {"LINESTRING", WktType::LineString},
    {"LINEARRING", WktType::LineString},
    {"POLYGON", WktType::Polygon},
    {"MULTIPOINT", WktType::MultiPoint},
    {"MULTILINESTRING", WktType::MultiLineString},
    {"MULTIPOLYGON", WktType::MultiPolygon},
    {"GEOMETRYCOLLECTION", WktType::Collection},
}};
constexpr std::array<std::string_view, 9> kRefusedTypes {
    "CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON", "MULTICURVE", "MULTISURFACE",
    "POLYHEDRALSURFACE", "TIN", "TRIANGLE", "GEOMETRY"};

constexpr int kDeepestNesting = 64;

class WktReader
{
public:
    WktReader(std::string_view text, std::string name)
        : text_(text)
        , name_(std::move(name))
    {}

    CurveNetwork run()
    {
        while (skipToGeometry()) {
            const std::size_t startLine = line_;
            source_ = static_cast<std::uint32_t>(line_);
            operand_ = OperandId(network_.operands.size());
            network_.operands.emplace_back().name = fmt::format("Line{}", line_);
            curveName_ = fmt::format("Line{}_Edges", line_);
            pointName_ = fmt::format("Line{}_Points", line_);
            skipSrid();
            readGeometry(0);
            requireEndOfLine(startLine);
        }
        return std::move(network_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { failAt(name_, line_, what); }

    // Text -----------------------------------------------------------------------------------

    static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    static bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

    bool atEnd() const { return at_ == text_.size(); }
    char peek() const { return atEnd() ? '\0' : text_[at_]; }

    void skipBlanks()
    {
        while (!atEnd() && isBlank(text_[at_])) {
            line_ += text_[at_++] == '\n' ? 1 : 0;
        }
    }

    /// Past empty lines and comments; false at the end of the text.
    bool skipToGeometry()
    {
        for (skipBlanks(); peek() == '#'; skipBlanks()) {
            at_ = std::min(text_.find('\n', at_), text_.size());
        }
        return !atEnd();
    }

    /// Nothing but a comment may follow a geometry in its line.
    void requireEndOfLine(std::size_t startLine)
    {
        while (!atEnd() && isBlank(text_[at_]) && text_[at_] != '\n') {
            ++at_;
        }
        if (!atEnd() && peek() != '\n' && peek() != '#') {
            fail(fmt::format("{} follows the geometry that starts in line {}; write one geometry "
                             "a line.",
                             here(), startLine));
        }
    }

    /// What stands here, for a message.
    std::string here() const
    {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        return atEnd() ? "the end of the file" : inQuotes(text_.substr(at_, end - at_));
    }

    /// The word here in capitals; empty if there is none.
    std::string word()
    {
        skipBlanks();
        std::string result;
        while (isLetter(peek())) {
            const char c = text_[at_++];
            result += c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
        }
        return result;
    }

    bool take(char c)
    {
        skipBlanks();
        if (peek() != c || atEnd()) {
            return false;
        }
        ++at_;
        return true;
    }
    void require(char c)
    {
        if (!take(c)) {
            fail(fmt::format("'{}' is missing before {}.", c, here()));
        }
    }

    double number()
    {
        skipBlanks();
        std::size_t end = at_;
        while (end < text_.size() && !isBlank(text_[end]) && text_[end] != ','
               && text_[end] != '(' && text_[end] != ')') {
            ++end;
        }
        double value = 0.0;
        if (end == at_ || !parseNumber(text_.substr(at_, end - at_), value)) {
            fail(fmt::format("a finite number is missing before {}.", here()));
        }
        at_ = end;
        return value;
    }

    // Grammar --------------------------------------------------------------------------------

    void skipSrid()
    {
        constexpr std::string_view kSrid = "SRID=";
        if (text_.substr(at_, kSrid.size()) == kSrid) {
            const std::size_t end = text_.find_first_of(";\n", at_);
            if (end == std::string_view::npos || text_[end] != ';') {
                fail("';' is missing after the SRID.");
            }
            at_ = end + 1;
        }
    }

    WktType readType()
    {
        skipBlanks();
        const std::size_t start = at_;
        std::string name = word();
        for (std::string_view suffix : {"", "Z", "M", "ZM"}) {
            if (!std::string_view(name).ends_with(suffix)) {
                continue;
            }
            const std::string stem = name.substr(0, name.size() - suffix.size());
            for (const TypeName& known : kTypes) {
                if (known.name == stem) {
                    return known.type;
                }
            }
            if (std::ranges::find(kRefusedTypes, stem) != kRefusedTypes.end()) {
                fail(fmt::format("{} is not supported; convert it to polygons or lines.", stem));
            }
        }
        at_ = start;
        fail(fmt::format("a geometry type such as POLYGON was expected, not {}.", here()));
    }

    /// Takes EMPTY, with or without a dimension (Z, M, ZM) before it.
    bool takeEmpty()
    {
        skipBlanks();
        if (!isLetter(peek())) {
            return false;
        }
        const std::size_t start = at_;
        std::string found = word();
        if (found == "Z" || found == "M" || found == "ZM") {
            skipBlanks();
            if (!isLetter(peek())) {
                return false;
            }
            found = word();
        }
        if (found != "EMPTY") {
            at_ = start;
            fail(fmt::format("'(' or EMPTY was expected, not {}.", here()));
        }
        return true;
    }

    /// ( item, item, ... ) or EMPTY.
    template<class Item>
    void readList(Item&& item)
    {
        if (takeEmpty()) {
            return;
        }
        require('(');
        do {
            item();
        } while (take(','));
        require(')');
    }

    void readGeometry(int depth)
    {
        if (depth > kDeepestNesting) {
            fail(fmt::format("collections are nested deeper than {}.", kDeepestNesting));
        }
        switch (readType()) {
            case WktType::Point:
                readList([this] { addEmbedded(readPosition()); });
                break;
            case WktType::LineString:
                readLine(Role::Constraint);
                break;
            case WktType::Polygon:
                readPolygon();
                break;
            case WktType::MultiPoint:
                readList([this] { readMemberPoint(); });
                break;
            case WktType::MultiLineString:
                readList([this] { readLine(Role::Constraint); });
                break;
            case WktType::MultiPolygon:
                readList([this] { readPolygon(); });
                break;
            case WktType::Collection:
                readList([this, depth] { readGeometry(depth + 1); });
                break;
        }
    }

    void readPolygon()
    {
        std::size_t rings = 0;
        readList([this, &rings] {
            readLine(Role::Boundary);
            ++rings;
        });
        if (rings > 1) {
            network_.operands.back().declaresHoles = true;
        }
    }

    /// A point of a MULTIPOINT: in brackets of its own or not.
    void readMemberPoint()
    {
        skipBlanks();
        if (peek() == '(' || isLetter(peek())) {
            readList([this] { addEmbedded(readPosition()); });
        }
        else {
            addEmbedded(readPosition());
        }
    }

    Vec2 readPosition()
    {
        const double x = number();
        const double y = number();
        for (int dropped = 0; dropped < 2; ++dropped) {
            skipBlanks();
            if (atEnd() || peek() == ',' || peek() == ')') {
                break;
            }
            number();
        }
        return {x, y};
    }

    void readLine(Role role)
    {
        positions_.clear();
        readList([this] { addPosition(readPosition()); });
        if (positions_.empty()) {
            return;
        }
        const bool closed = positions_.front() == positions_.back();
        if (role == Role::Boundary && !closed) {
            fail("the ring is not closed; repeat its first point at its end.");
        }
        addCurves(role, closed);
    }

    /// Points that repeat the one before add nothing.
    void addPosition(Vec2 p)
    {
        if (positions_.empty() || positions_.back() != p) {
            positions_.push_back(p);
        }
    }

    // Network --------------------------------------------------------------------------------

    void addEmbedded(Vec2 p)
    {
        network_.embedded.push_back({network_.addPoint(p), operand_, pointName_});
    }

    void addCurves(Role role, bool closed)
    {
        const std::size_t count = positions_.size();
        const PointId first = network_.addPoint(positions_.front());
        PointId previous = first;
        for (std::size_t i = 1; i < count; ++i) {
            const bool back = closed && i + 1 == count;
            const PointId next = back ? first : network_.addPoint(positions_[i]);
            addCurve(previous, next, role);
            previous = next;
        }
        if (count == 1) {
            addCurve(first, first, role);
        }
    }

    void addCurve(PointId start, PointId end, Role role)
    {
        NetworkCurve curve;
        curve.start = start;
        curve.end = end;
        curve.operand = operand_;
        curve.role = role;
        curve.source = source_;
        network_.curves.push_back(std::move(curve));
        network_.curveNames.push_back(curveName_);
    }

    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;

    OperandId operand_;
    std::uint32_t source_ = 0;
    std::string curveName_;
    std::string pointName_;
    std::vector<Vec2> positions_; ///< of the line being read
    CurveNetwork network_;
};

} // namespace

CurveNetwork parseWkt(std::string_view text, const std::string& name, const RoleLists& roles)
{
    CurveNetwork network = WktReader(text, name).run();
    for (NetworkCurve& curve : network.curves) {
        roles.apply(curve, curve.source);
    }
    return network;
}

CurveNetwork readWkt(const std::filesystem::path& path, const RoleLists& roles)
{
    return parseWkt(readTextFile(path), path.string(), roles);
}

} // namespace tessera
