//! What the text of programs always shows, and nothing raises: why.
#include "rules/alarms/tables.hpp"

namespace maclint::alarms {

std::span<const NotFound> not_found() {
    constexpr std::string_view of_16i = alarm_lists[0], of_30i = alarm_lists[1];
    constexpr std::string_view nobody_looks = "nothing looks for it yet";
    static constexpr NotFound rows[] = {
        {of_16i, "009", nobody_looks},  {of_16i, "051", nobody_looks},  {of_16i, "073", nobody_looks},
        {of_16i, "074", nobody_looks},  {of_16i, "113", nobody_looks},  {of_16i, "129", nobody_looks},
        {of_16i, "149", nobody_looks},  {of_16i, "231", nobody_looks},  {of_16i, "232", nobody_looks},
        {of_30i, "009", nobody_looks},  {of_30i, "039", nobody_looks},  {of_30i, "051", nobody_looks},
        {of_30i, "054", nobody_looks},  {of_30i, "056", nobody_looks},  {of_30i, "073", nobody_looks},
        {of_30i, "074", nobody_looks},  {of_30i, "113", nobody_looks},  {of_30i, "114", nobody_looks},
        {of_30i, "116", nobody_looks},  {of_30i, "124", nobody_looks},  {of_30i, "125", nobody_looks},
        {of_30i, "126", nobody_looks},  {of_30i, "128", nobody_looks},  {of_30i, "129", nobody_looks},
        {of_30i, "149", nobody_looks},  {of_30i, "199", nobody_looks},  {of_30i, "231", nobody_looks},
        {of_30i, "232", nobody_looks},  {of_30i, "311", nobody_looks},  {of_30i, "1013", nobody_looks},
        {of_30i, "1014", nobody_looks}, {of_30i, "1090", nobody_looks}, {of_30i, "1091", nobody_looks},
        {of_30i, "1092", nobody_looks}, {of_30i, "1095", nobody_looks}, {of_30i, "1097", nobody_looks},
        {of_30i, "1099", nobody_looks}, {of_30i, "1115", nobody_looks}, {of_30i, "1120", nobody_looks},
        {of_30i, "1133", nobody_looks}, {of_30i, "1134", nobody_looks}, {of_30i, "1139", nobody_looks},
        {of_30i, "1141", nobody_looks}, {of_30i, "1142", nobody_looks}, {of_30i, "1143", nobody_looks},
        {of_30i, "1146", nobody_looks}, {of_30i, "1152", nobody_looks}, {of_30i, "5044", nobody_looks},
        {of_30i, "5074", nobody_looks},
    };
    return rows;
}

} // namespace maclint::alarms
