//! DIN634: zero shifts are left switched off.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "rules/dinplus/left_active.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule g920_not_reset{
    .code = "DIN634",
    .name = "g920-not-reset",
    .summary = "The program ends with zero shifts switched off by G920 or G921",
    .why = "Positions count from the machine zero, with G921 for the slide and not for the tool, until G980 "
           "or G981: the next program moves to other places than it says.",
    .severity = Severity::error,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ModalWrite, dataflow::CallMade, dataflow::ExitState, dataflow::Store,
                             dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path", "Code '{0}' is still active when the program ends.",
                  "Write {1} before the end."},
                 {"some-paths", "Code '{0}' is still active on some of the paths on which the program ends.",
                  "Write {1} on those, too."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 T12
N11 G921
N12 G701 X300 Z450
N13 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 T12
N11 G921
N12 G701 X300 Z450
N13 G981
N14 M30
END
)nc"}},
    .sources = {"SEED-003:12741", "SEED-003:18155-18163", "SEED-003:18391-18397"},
    .check = &check_left_at_end<ModalRole::offset_suspension>,
};

} // namespace maclint::rules
