//! SIN504: a frame that the next block deletes.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule frame_replaces{
    .code = "SIN504",
    .name = "frame-replaces",
    .summary = "A frame is written and deleted by the next one before anything has moved",
    .why = "TRANS, ROT, SCALE and MIRROR delete the whole frame that was in force, ATRANS, AROT, "
           "ASCALE and AMIRROR add to it. The first of the two does nothing.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Frame without effect: '{1}' deletes '{0}', with which nothing has moved.",
                  "Write the form with A, which adds to it, or remove the first one."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
TRANS X50 Y20
ROT RPL=45
G0 X0 Y0
TRANS
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
TRANS X50 Y20
AROT RPL=45
G0 X0 Y0
TRANS
M30
)nc"}},
    .sources = {"SEED-004:71-135"},
    .check = SyntaxErrorKind::frame_lost,
};

} // namespace maclint::rules
