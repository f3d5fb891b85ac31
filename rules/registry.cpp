//! The explicit list of all rules, in the order of their codes. A new rule is one declaration and one line
//! here.
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace maclint {
namespace rules {
extern const Rule uninitialised_local;                   // MAC209
extern const Rule zero_test_misses_vacant;               // MAC220
extern const Rule vacant_in_relational_comparison;       // MAC221
extern const Rule vacancy_lost_in_arithmetic;            // MAC222
extern const Rule vacancy_test_never_true;               // MAC228
extern const Rule infinite_loop_unchanged;               // MAC319
extern const Rule infinite_loop_step;                    // MAC320
extern const Rule modal_state_not_restored;              // MAC501
extern const Rule compensation_or_transform_left_active; // MAC502
extern const Rule feed_or_speed_not_restored;            // MAC503
extern const Rule motion_mode_not_restored;              // MAC504
extern const Rule restore_from_wrong_variable;           // MAC505
extern const Rule saved_value_lost;                      // MAC506
extern const Rule single_block_suppression_not_restored; // MAC515
extern const Rule saved_after_change;                    // MAC517
extern const Rule modal_state_forced;                    // MAC518
extern const Rule float_equality;                        // MAC710
extern const Rule float_loop_counter;                    // MAC711
extern const Rule constant_condition;                    // MAC718
} // namespace rules

namespace {

const std::array list{
    &rules::uninitialised_local,
    &rules::zero_test_misses_vacant,
    &rules::vacant_in_relational_comparison,
    &rules::vacancy_lost_in_arithmetic,
    &rules::vacancy_test_never_true,
    &rules::infinite_loop_unchanged,
    &rules::infinite_loop_step,
    &rules::modal_state_not_restored,
    &rules::compensation_or_transform_left_active,
    &rules::feed_or_speed_not_restored,
    &rules::motion_mode_not_restored,
    &rules::restore_from_wrong_variable,
    &rules::saved_value_lost,
    &rules::single_block_suppression_not_restored,
    &rules::saved_after_change,
    &rules::modal_state_forced,
    &rules::float_equality,
    &rules::float_loop_counter,
    &rules::constant_condition,
};

bool equal_without_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool is_alias(std::string_view aliases, std::string_view code) {
    for (std::size_t begin = 0; begin < aliases.size();) {
        const std::size_t end = std::min(aliases.find(' ', begin), aliases.size());
        if (equal_without_case(aliases.substr(begin, end - begin), code)) return true;
        begin = end + 1;
    }
    return false;
}

} // namespace

std::span<const Rule* const> all_rules() { return list; }

const Rule* find_rule(std::string_view code_or_name) {
    const auto found = std::ranges::find_if(list, [&](const Rule* rule) {
        return equal_without_case(rule->code, code_or_name) || equal_without_case(rule->name, code_or_name) ||
               is_alias(rule->aliases, code_or_name);
    });
    return found == list.end() ? nullptr : *found;
}

} // namespace maclint
