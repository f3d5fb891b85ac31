//! What the text of programs always shows, and nothing raises: why.
#include "rules/alarms/tables.hpp"

namespace maclint::alarms {

std::span<const NotFound> not_found() {
    constexpr std::string_view of_16i = alarm_lists[0], of_30i = alarm_lists[1];
    // clang-format off
    static constexpr NotFound rows[] = {
        {of_16i, "149", "lines of tool life data are not read one by one"},
        {of_16i, "231", "lines of parameters are not read one by one"},
        {of_16i, "232", "no document has the number on this list"},
        {of_30i, "056", "angles of drawing dimensions are not calculated"},
        {of_30i, "113", "no function that such a control refuses is known"},
        {of_30i, "114", "what is wrong in an expression has the number 1125 there"},
        {of_30i, "149", "lines of tool life data are not read one by one"},
        {of_30i, "231", "lines of parameters are not read one by one"},
        {of_30i, "311", "names of files are not held against their form"},
        {of_30i, "1090", "each statement has a number of its own; what is left for this one no document tells"},
        {of_30i, "1146", "no document has the form of G10.1"},
        {of_30i, "1152", "no document has the form of G31.8 and G31.9"},
        {of_30i, "5044", "no document has the number"},
    };
    // clang-format on
    return rows;
}

} // namespace maclint::alarms
