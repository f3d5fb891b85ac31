//! DIN634: zero shifts are left switched off.
#include "rules/dinplus/left_active.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule g920_not_reset{
    .code = "DIN634",
    .name = "g920-not-reset",
    .aliases = "",
    .summary = "The program ends with zero shifts switched off by G920 or G921",
    .why = "Positions count from the machine zero, with G921 for the slide and not for the tool, until G980 "
           "or G981: the next program moves to other places than it says.",
    .severity = Severity::error,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"every-path", "'{0}' is still active when the program ends. Cancel it with {1} first."},
                 {"some-paths",
                  "'{0}' is still active on some of the paths on which the program ends. Cancel "
                  "it with {1} on those, too."}},
    .bad = {{"dinplus", "MACHINING\n"
                        "N10 T12\n"
                        "N11 G921\n"
                        "N12 G701 X300 Z450\n"
                        "N13 M30\n"
                        "END\n"}},
    .good = {{"dinplus", "MACHINING\n"
                         "N10 T12\n"
                         "N11 G921\n"
                         "N12 G701 X300 Z450\n"
                         "N13 G981\n"
                         "N14 M30\n"
                         "END\n"}},
    .alarms = {},
    .sources = {"SEED-003:12741", "SEED-003:18155-18163", "SEED-003:18391-18397"},
    .check = &check_left_at_end<ModalRole::offset_suspension>,
};

} // namespace maclint::rules
