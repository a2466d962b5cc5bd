// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "io/text_file.h"
#include "recover/recover.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tessera::cli
{

inline const std::map<std::string, FillRule> kFillRules {
    {"even-odd", FillRule::EvenOdd}, {"nonzero", FillRule::NonZero},
    {"positive", FillRule::Positive}, {"negative", FillRule::Negative},
    {"all", FillRule::All},           {"hull", FillRule::Hull},
};
/// Those that mean something for an overlay.
inline const std::map<std::string, FillRule> kBooleanFillRules = [] {
    auto rules = kFillRules;
    rules.erase("hull");
    return rules;
}();
inline const std::map<std::string, int> kOrders {{"1", 1}, {"2", 2}};
inline const std::map<std::string, RecoveryStrategy> kStrategies {
    {"cavity", RecoveryStrategy::Cavity},
    {"steiner", RecoveryStrategy::Steiner},
};

/// Takes the names and nothing else: CLI11's own transformer lets the numbers behind them pass too.
/// Names those of `shown` where it refuses. Both must outlive the validator.
template<class Choice>
CLI::Validator namesOnly(const std::map<std::string, Choice>& choices,
                         const std::map<std::string, Choice>& shown)
{
    const auto toNumber = [&choices, &shown](std::string& text) -> std::string {
        const auto found = choices.find(text);
        if (found == choices.end()) {
            std::string names;
            for (const auto& [name, choice] : shown) {
                names += (names.empty() ? "" : ", ") + name;
            }
            return fmt::format("'{}' is not one of {}", text, names);
        }
        text = std::to_string(static_cast<int>(found->second));
        return {};
    };
    return CLI::Validator(toNumber, "");
}

template<class Choice>
CLI::Validator namesOnly(const std::map<std::string, Choice>& choices)
{
    return namesOnly(choices, choices);
}

/// Whole numbers between commas; CLI11 would take an empty one for 0.
inline void addNumberList(CLI::App& command, const char* name, std::vector<std::int32_t>& numbers,
                   const char* description)
{
    command
        .add_option_function<std::string>(
            name,
            [&numbers, name](const std::string& text) {
                for (std::size_t begin = 0; begin <= text.size();) {
                    const std::size_t end = std::min(text.find(',', begin), text.size());
                    const std::string word = text.substr(begin, end - begin);
                    std::int64_t number = 0;
                    if (!parseNumber(word, number)
                        || number != static_cast<std::int32_t>(number)) {
                        throw CLI::ValidationError(
                            name, fmt::format("'{}' is not a whole number; give numbers with "
                                              "commas between them, for example 1,4",
                                              word));
                    }
                    numbers.push_back(static_cast<std::int32_t>(number));
                    begin = end + 1;
                }
            },
            description)
        ->type_name("LIST")
        ->trigger_on_parse();
}

} // namespace tessera::cli
