// SPDX-License-Identifier: MIT
#include "cli/size_options.h"

#include "base/error.h"
#include "cli/run_options.h"
#include "expression/expression_source.h"
#include "io/text_file.h"
#include "vtk/background_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace tessera::cli
{

namespace
{

/// One value of an option, in parts.
class Value
{
public:
    Value(const char* option, const char* form, const std::string& text)
        : option_(option)
        , form_(form)
        , text_(text)
    {}

    [[noreturn]] void refuse() const
    {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("{} is given as '{}'; write {}.", option_, text_, form_));
    }

    std::vector<double> numbers(std::string_view list) const
    {
        std::vector<double> values;
        for (const std::string_view part : split(list)) {
            double value = 0.0;
            if (!parseNumber(part, value) || !std::isfinite(value)) {
                refuse();
            }
            values.push_back(value);
        }
        return values;
    }

    std::set<std::int64_t> wholeNumbers(std::string_view list) const
    {
        std::set<std::int64_t> values;
        for (const std::string_view part : split(list)) {
            std::int64_t value = 0;
            if (!parseNumber(part, value)) {
                refuse();
            }
            values.insert(value);
        }
        return values;
    }

    /// What stands before and after the colon; refused without one.
    std::pair<std::string_view, std::string_view> halves() const
    {
        const std::size_t colon = text_.find(':');
        if (colon == std::string::npos) {
            refuse();
        }
        const std::string_view all = text_;
        return {all.substr(0, colon), all.substr(colon + 1)};
    }

    /// H[,R[,FAR_H,FAR_R]] from position first on.
    SizeLaw law(const std::vector<double>& values, std::size_t first) const
    {
        const std::size_t count = values.size() - std::min(first, values.size());
        if (count != 1 && count != 2 && count != 4) {
            refuse();
        }
        SizeLaw law {values[first]};
        law.radius = count > 1 ? values[first + 1] : 0.0;
        if (count == 4) {
            law.farSize = values[first + 2];
            law.farRadius = values[first + 3];
        }
        if (!(law.size > 0.0) || law.radius < 0.0
            || (count == 4 && (law.farSize < law.size || law.farRadius <= law.radius))) {
            throw Error(ErrorKind::InvalidOption,
                        fmt::format("{} is given as '{}'; sizes must be above 0, distances not "
                                    "negative, and FAR_H and FAR_R not less than H and R.",
                                    option_, text_));
        }
        return law;
    }

private:
    static std::vector<std::string_view> split(std::string_view list)
    {
        std::vector<std::string_view> parts;
        for (;;) {
            const std::size_t comma = list.find(',');
            parts.push_back(list.substr(0, comma));
            if (comma == std::string_view::npos) {
                return parts;
            }
            list.remove_prefix(comma + 1);
        }
    }

    const char* option_;
    const char* form_;
    const std::string& text_;
};

PointSize pointSize(const std::string& text)
{
    const Value value("--size-at", "X,Y,H or X,Y,H,R or X,Y,H,R,FAR_H,FAR_R", text);
    const std::vector<double> numbers = value.numbers(text);
    if (numbers.size() < 3) {
        value.refuse();
    }
    return {{numbers[0], numbers[1]}, value.law(numbers, 2)};
}

CurveSize curveSize(const std::string& text, const Inputs& inputs)
{
    const Value value("--size-on", "LIST:H or LIST:H,R or LIST:H,R,FAR_H,FAR_R", text);
    const auto [list, law] = value.halves();
    const std::set<std::int64_t> chosen = value.wholeNumbers(list);
    CurveSize size {{}, value.law(value.numbers(law), 0)};
    std::set<std::int64_t> found;
    for (std::size_t c = 0; c < inputs.numberOfCurve.size(); ++c) {
        if (chosen.contains(inputs.numberOfCurve[c])) {
            size.curves.emplace_back(c);
            found.insert(inputs.numberOfCurve[c]);
        }
    }
    for (const std::int64_t number : chosen) {
        if (!found.contains(number)) {
            throw Error(ErrorKind::InvalidOption,
                        fmt::format("No segment has the marker, line or edge number {} that "
                                    "--size-on lists.",
                                    number));
        }
    }
    return size;
}

void addRegionSizes(const std::string& text, LocalSizes& sizes)
{
    const Value value("--size-in", "LIST:H, operands counted from 1, or X,Y,H", text);
    if (text.find(':') == std::string::npos) {
        const std::vector<double> numbers = value.numbers(text);
        if (numbers.size() != 3) {
            value.refuse();
        }
        sizes.regions.push_back({{}, {numbers[0], numbers[1]}, value.law(numbers, 2).size});
        return;
    }
    const auto [list, size] = value.halves();
    const std::vector<double> numbers = value.numbers(size);
    if (numbers.size() != 1) {
        value.refuse();
    }
    for (const std::int64_t number : value.wholeNumbers(list)) {
        if (number < 1 || number > 0xfffffffeLL) {
            value.refuse();
        }
        sizes.regions.push_back({OperandId(static_cast<std::uint32_t>(number - 1)), {},
                                 value.law(numbers, 0).size});
    }
}

} // namespace

void addSizeOptions(CLI::App& command, SizeArguments& a)
{
    const auto add = [&command](const char* name, std::vector<std::string>& to, const char* form,
                                const char* text) {
        command.add_option(name, to, text)->type_name(form)->take_all()->expected(1)->delimiter(
            '\0');
    };
    command.add_option("--curvature", a.curvature,
                       "Pieces for a full turn of a curve, 3 to 10000; default 20");
    command.add_option("--chord-error", a.chordError,
                       "Greatest distance between a curve and its pieces");
    command.add_option("--gap", a.gap, "Elements across narrow gaps between curves");
    add("--size-at", a.at, "X,Y,H[,R[,FAR_H,FAR_R]]",
        "Size H at a point, up to the distance R; from there on it grows by --growth, or linearly "
        "to FAR_H at the distance FAR_R. May be repeated, as all --size-... may");
    add("--size-on", a.on, "LIST:H[,R[,FAR_H,FAR_R]]",
        "The same on curves: markers (.poly), lines (.wkt) or edges (CAD)");
    add("--size-in", a.in, "LIST:H | X,Y,H",
        "Size inside operands, counted from 1, or in the region around a point");
    add("--size-expr", a.expressions, "EXPR", "Size as an expression in x and y");
    add("--size-from", a.files, "FILE.vtu:ARRAY", "Sizes at the nodes of another mesh");
}

LocalSizes localSizes(const SizeArguments& a, const Inputs& inputs)
{
    LocalSizes sizes;
    sizes.piecesPerTurn = a.curvature.value_or(sizes.piecesPerTurn);
    sizes.chordError = positive(a.chordError, "--chord-error");
    sizes.gap = positive(a.gap, "--gap");
    for (const std::string& text : a.at) {
        sizes.points.push_back(pointSize(text));
    }
    for (const std::string& text : a.on) {
        sizes.curves.push_back(curveSize(text, inputs));
    }
    for (const std::string& text : a.in) {
        addRegionSizes(text, sizes);
    }
    for (const std::string& text : a.expressions) {
        sizes.areas.push_back(expressionSource(text));
    }
    for (const std::string& text : a.files) {
        sizes.areas.push_back(backgroundSource(readBackground(text)));
    }
    return sizes;
}

} // namespace tessera::cli
