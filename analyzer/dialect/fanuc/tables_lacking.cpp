//! The table of what controls lack.
#include "analyzer/dialect/fanuc/tables_lacking.hpp"

#include "analyzer/program/lacking.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::fanuc {
namespace {

constexpr std::string_view older = "fanuc-16i fanuc-0i-c", haas = "haas haas-1999",
                           all_fanuc = "fanuc fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i";

// clang-format off
constexpr Lacking rows[] = {
    // extra                   models     fault                doc.   else    cure                                          source
    {Extra::power,            older,     lacking::function,  true,  "",     "Multiply, or calculate EXP[#2*LN[#1]]",      "ISORP: of newer macros; ZAPP-MATH lists none"},
    {Extra::power,            haas,      lacking::function,  false, "",     "Multiply",                                   "T"},
    {Extra::parameter,        older,     lacking::function,  true,  "",     "Write the value into the program",           "ISORP: of newer macros; ZAPP-MATH lists none"},
    {Extra::parameter,        haas,      lacking::function,  false, "",     "Write the value into the program",           "T"},
    {Extra::remainder,        older,     lacking::function,  false, "",     "Calculate #1-FIX[#1/#2]*#2",                 "SEED-001:263-278 lists none for the 21i; T: some take it"},
    {Extra::logarithm,        haas,      lacking::function,  false, "",     "Calculate the value beforehand",             "T: H99:374 names MOD alone"},
    {Extra::code_of_decimals, haas,      lacking::function,  false, "",     "Calculate with FIX",                         "T: H99:374 names MOD alone"},
    {Extra::angle_of_one,     older,     lacking::form,      false, "",     "Write a divisor, as in ATAN[#1]/[1]",        "SEED-001:263-268 has ATAN[]/[] alone; ZAPP-MATH has both"},
    {Extra::angle_of_two,     older,     lacking::form,      true,  "",     "Write ATAN[#1]/[#2]",                        "SEED-001:263-268; ISORP: of newer macros"},
    {Extra::angle_of_two,     haas,      lacking::form,      false, "",     "Write ATAN[#1]/[#2]",                        "T"},
    {Extra::named_variable,   older,     lacking::name,      true,  "",     "Use its number",                             "GH-ALM 1096-1099: alarms of the 30i alone"},
    {Extra::named_variable,   haas,      lacking::name,      false, "",     "Use its number",                             "T"},
    {Extra::bare_condition,   all_fanuc, lacking::condition, true,  "haas", "Compare, as in [#1 NE 0]",                   "SEED-001:375-415; SINHA-EXP; Haas: HAAS-118, all expressions set a conditional value"},
    {Extra::macro_a,          all_fanuc, lacking::macro_a,   false, "",     "Write it as in #102=100.0+0",                "T: macro B reads it as a call of the program whose number #102 holds"},
    {Extra::macro_a_jump,     all_fanuc, lacking::macro_a,   false, "",     "Write it as in GOTO50",                      "T: H80 of macro A; macro B calls the program of the number"},
    {Extra::macro_a_test,     all_fanuc, lacking::macro_a,   false, "",     "Write it as in IF[#530EQ25]GOTO50",          "T: H81 to H86 of macro A; macro B calls the program of the number"},
    {Extra::macro_a_alarm,    all_fanuc, lacking::macro_a,   false, "",     "Write it as in #3000=5(TEXT)",               "T: H99 of macro A; macro B calls the program of the number"},
};
// clang-format on

/// Whether the list, separated by blanks, holds the word.
bool lists(std::string_view list, std::string_view word) {
    for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' ')) return true;
    }
    return false;
}

} // namespace

const Lacking* lacking_on(const ControlModel& control, Extra extra) {
    const auto* row = std::ranges::find_if(rows, [&](const Lacking& candidate) {
        return candidate.extra == extra && lists(candidate.models, control.model);
    });
    return row == std::end(rows) ? nullptr : row;
}

} // namespace maclint::fanuc
