//! MAC527: a code that the control refuses where another is in force.
#include "analyzer/program/model.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_switch.hpp"
#include "rules/words/row_text.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule code_forbidden_here{
    .code = "MAC527",
    .name = "code-forbidden-here",
    .aliases = "DIN112 DIN113 DIN234",
    .summary = "A code stands where the control refuses it",
    .why = "While a cycle, a compensation or another plane is in force the control refuses some codes: it "
           "stops with an"
           " alarm, or carries them out as something else.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"under", "Code {0} while {1} is in force: {2}.", "Switch {1} off before."},
                 {"section", "Code {0} in {1}: {2}.", "Move it to where it belongs."},
                 {"on", "Code {0} while the {1} is on, since {3}: {2}.", "Switch it off before."},
                 {"off", "Code {0} without what it needs: {2}.",
                  "Give it the {1} before, or leave {0} out."}},
    .bad = {{"fanuc", R"nc(
O9527(PROBE)
G90 G54 G0 X0 Y0
G41 G1 X10. D1 F200.
G31 X50. F50.
G40 G1 X0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9527(PROBE)
G90 G54 G0 X0 Y0
G41 G1 X10. D1 F200.
G40 G1 X20.
G31 X50. F50.
M30
)nc"}},
    .sources = {"T: alarm 036; further rows name theirs"},
    .check = RowCheck{.says = RowStatement::refused, .check = &check},
};

namespace {

/// Whether all codes stand in sections of contours because the word that ends those is missing: one cause,
/// which another rule tells.
bool machining_is_missing(const RowOfBlock& block) {
    const ProgramAnalysis& analysis = block.block.analysis;
    const SectionKind* kind = kind_of(analysis.control(), block.block.section);
    return kind != nullptr && kind->role == SectionKind::Role::contour &&
           !queries::has_section(analysis.program(), SectionKind::Role::machining);
}

/// "line 12": of the block that has switched it on.
std::string since(const RowOfBlock& block) {
    const Offset at = block.switched.on_at;
    return at == machine::Switched::nowhere ? "before the program is called"
                                            : "line " + line_number(block.block.analysis.file(), at);
}

void report_switch(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    const bool is_on = !row.while_on.empty();
    block.report(reporter, block.code, is_on ? "on" : "off",
                 {block.text_of(block.code), std::string(is_on ? row.while_on.view() : first_switch_off(row)),
                  std::string(row.effect), since(block)});
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    if (!row.while_on.empty() || !row.while_off.empty()) return report_switch(block, reporter);
    const bool under = !block.under.empty();
    if (!under && machining_is_missing(block)) return;
    block.report(reporter, block.code, under ? "under" : "section",
                 {block.text_of(block.code), under ? block.under : std::string(block.block.section.kind),
                  std::string(row.effect)});
}

} // namespace
} // namespace maclint::rules
