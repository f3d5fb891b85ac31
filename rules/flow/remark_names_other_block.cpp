//! MAC341: a remark says where a jump goes, and the jump goes elsewhere.
#include "rules/flow/remark_names_other_block_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule remark_names_other_block{
    .code = "MAC341",
    .name = "remark-names-other-block",
    .summary = "A jump goes to another block, or another tool is called, than the remark beside it says",
    .why = "One of the two was not changed with the other: the jump goes where it went before, or the next "
           "reader believes the remark.",
    .severity = Severity::note,
    .precision = Precision::high,
    .needs = {Capability::jumps},
    .messages = {{"other", "Remark and jump differ: '{0}' goes to N{1}, and the remark '{2}' says N{3}.",
                  "Correct the jump, or the remark."},
                 {"tool", "Remark and tool differ: '{0}' calls tool {1}, and the remark '{2}' says T{3}.",
                  "Correct the tool, or the remark."}},
    .bad = {{"fanuc", R"nc(
O9341(CLAMP)
N3 #9=50.
IF[#1004EQ1]GOTO3
(SENSOR IS ON, GO TO N5)
M117
N5 G91 G31 X#24 F#9
G90
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9341(CLAMP)
N3 #9=50.
IF[#1004EQ1]GOTO5
(SENSOR IS ON, GO TO N5)
M117
N5 G91 G31 X#24 F#9
G90
M99
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const OtherBlockNamed& other : find_other_blocks_named(analysis)) {
        const Span span = program.effects[other.jump].span;
        Finding& finding = reporter.report({analysis, other.jump}, span, "other",
                                           {quoted(program, span), std::to_string(other.target),
                                            quoted(program, other.remark), std::to_string(other.named)});
        finding.related.push_back({analysis.source(), other.remark, "the remark"});
    }
    for (const OtherToolNamed& other : find_other_tools_named(analysis)) {
        Finding& finding = reporter.report({analysis, other.tool}, other.tool, "tool",
                                           {quoted(program, other.tool), std::to_string(other.called),
                                            quoted(program, other.remark), std::to_string(other.named)});
        finding.related.push_back({analysis.source(), other.remark, "the remark"});
    }
}

} // namespace
} // namespace maclint::rules
