//! DIN632: a tilted working plane is left active.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "rules/dinplus/left_active.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule g16_not_reset{
    .code = "DIN632",
    .name = "g16-not-reset",
    .summary = "The program ends with the working plane tilted by G16",
    .why = "Positions are still turned and shifted: with M99 the next part begins in the tilted plane, and "
           "zero shifts are not allowed in it.",
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
N10 T9
N11 G16 B45 I38 K-10 Q1
N12 G0 X10 Z2
N13 G1 Z-24
N14 G0 Z20
N15 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 T9
N11 G16 B45 I38 K-10 Q1
N12 G0 X10 Z2
N13 G1 Z-24
N14 G0 Z20
N15 G16 Q0
N16 M30
END
)nc"}},
    .sources = {"SEED-003:23206", "SEED-003:23218"},
    .check = &check_left_at_end<ModalRole::tilted_plane>,
};

} // namespace maclint::rules
