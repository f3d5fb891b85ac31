//! MAC567: a reference position return that runs down to the work first.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <cmath>
#include <string>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule return_through_zero{
    .code = "MAC567",
    .name = "reference-return-through-zero",
    .summary = "A reference position return under G90 runs down to its point first",
    .why = "G28 and G30 go to the point that their words name, at rapid traverse, and to the reference "
           "position from "
           "there. Under G90 the point is one of the work: Z0 is its surface.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"down", "Return through the work: '{0}' runs down to Z{1} first, from Z{2}.",
                  "Write G91 before it, or a point above the work."},
                 {"from_somewhere",
                  "Return through the work: '{0}' runs to Z{1} first, whatever height the tool is at.",
                  "Write G91 before it, or a point above the work."},
                 {"up",
                  "Return by the work's zero: '{0}' runs to Z{1} of the work first, from Z{2} as it stands "
                  "here; from above it would run down.",
                  "Write G91 before it, or a point above the work."}},
    .bad = {{"fanuc", R"nc(
O9567(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
G28 Z0
M30
)nc"},
            {"fanuc", R"nc(
O9567(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
G0 Z#1
G28 Z0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9567(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
G28 Z100.
G28 X0 Y0
T2 M6
G91 G28 Z0
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    constexpr std::size_t z = 2;
    const char letter = at.letters().axes[z];
    const auto point = at.step.words.number(letter);
    if (!at.step.to_reference || !point || point->value > 0 || !point->is_length()) return;
    if (!at.after().of(ModalRole::distance).is(at.letters().absolute)) return;
    const double height = at.before().position[z];
    const bool is_unknown = std::isnan(height);
    const bool is_at_work =
        at.before().length_offset.is_known() && at.before().length_offset.value > 0 && at.before().cut.is(1);
    if (is_unknown && !is_at_work) return;
    const bool is_up = height <= point->value;
    const char* message = is_unknown ? "from_somewhere" : is_up ? "up" : "down";
    Finding& finding = reporter.report(
        at.cause(), at.block(), message,
        {at.quoted_block(), number_word(point->value), is_unknown ? std::string() : number_word(height)});
    if (is_up) finding.severity = Severity::note;
}

} // namespace
} // namespace maclint::rules
