// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "recover/recover.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <map>
#include <string>

namespace tessera::cli
{

inline const std::map<std::string, FillRule> kFillRules {
    {"even-odd", FillRule::EvenOdd}, {"nonzero", FillRule::NonZero},
    {"positive", FillRule::Positive}, {"negative", FillRule::Negative},
    {"all", FillRule::All},           {"hull", FillRule::Hull},
};
inline const std::map<std::string, RecoveryStrategy> kStrategies {
    {"cavity", RecoveryStrategy::Cavity},
    {"steiner", RecoveryStrategy::Steiner},
};

/// Takes the names and nothing else: CLI11's own transformer lets the numbers behind them pass too.
/// The choices must outlive the validator.
template<class Choice>
CLI::Validator namesOnly(const std::map<std::string, Choice>& choices)
{
    const auto toNumber = [&choices](std::string& text) -> std::string {
        const auto found = choices.find(text);
        if (found == choices.end()) {
            std::string names;
            for (const auto& [name, choice] : choices) {
                names += (names.empty() ? "" : ", ") + name;
            }
            return fmt::format("'{}' is not one of {}", text, names);
        }
        text = std::to_string(static_cast<int>(found->second));
        return {};
    };
    return CLI::Validator(toNumber, "");
}

} // namespace tessera::cli
