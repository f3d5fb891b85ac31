//! Made by tests/tools/write_precision from docs/verdicts: what was read of the findings of each rule.
#include "cli/report/measured_precision.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli {
namespace {

// Code, precision; errors and warnings, and notes, true and decided ones, where there are enough.
// clang-format off
constexpr std::array<MeasuredRule, 10> measured_rules{{
    {"MAC106", Precision::very_high, {6, 6}, {}},
    {"MAC118", Precision::very_high, {9, 9}, {}},
    {"MAC121", Precision::very_high, {44, 45}, {}},
    {"MAC209", Precision::high, {22, 27}, {}},
    {"MAC301", Precision::high, {11, 12}, {}},
    {"MAC455", Precision::very_high, {8, 8}, {}},
    {"MAC501", Precision::very_high, {9, 9}, {}},
    {"MAC502", Precision::high, {7, 8}, {}},
    {"MAC503", Precision::high, {12, 13}, {}},
    {"MAC702", Precision::very_high, {5, 5}, {}},
}};
// clang-format on

} // namespace

const MeasuredRule* measured(std::string_view code) {
    const auto* const found = std::ranges::find(measured_rules, code, &MeasuredRule::code);
    return found == measured_rules.end() ? nullptr : &*found;
}

std::span<const MeasuredRule> all_measured_rules() { return measured_rules; }

} // namespace maclint::cli
