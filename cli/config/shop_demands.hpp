//! What a control's entry of a configuration asks of programs: limits, and blocks that must stand there.
#pragma once

#include "analyzer/program/shop_demands.hpp"
#include "cli/config/json_tree.hpp"
#include "cli/config/machine_facts.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// Why a value is wrong, a sentence without its full stop.
struct WrongValue {
    Span span;
    std::string message;
};

/// The keys of "limits" that say what programs may command: "speed", "X".
[[nodiscard]] std::vector<std::string> shop_limit_names();
/// Takes such a key in: its greatest value, or its least and its greatest.
[[nodiscard]] std::optional<WrongValue> read_shop_limit(const JsonMember& member, ShopLimits& limits);

/// The keys whose blocks must stand in programs: "at-start".
[[nodiscard]] std::vector<std::string> demand_names();
[[nodiscard]] std::optional<WrongValue> read_demand(const JsonMember& member, ShopDemands& demands);

/// What is shown of them: "speed 50 to 8000", "at-end M9"; empty: nothing is asked.
[[nodiscard]] std::vector<std::string> words_of(const ShopDemands& demands);

/// Of a rule's example: the keys of a control's entry, which are right.
[[nodiscard]] MachineFacts facts_of_example(std::string_view keys);

} // namespace maclint::cli
