//! DIN317: a value of the interpolation that nothing has taken over before.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/machine/machine_reads.hpp"
#include "analyzer/queries/structure/text_order.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule interpolation_read_early{
    .code = "DIN317",
    .name = "a-variable-without-g904",
    .summary = "A variable #a is read that no code has filled, or before the control gets there",
    .why = "#a0 to #a10 have values only behind the code that takes them over, and the control reads ahead: "
           "without G909 it works with old values.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"empty", "Value not taken over: '{0}' is read, and {1} does not stand before it.",
                  "Write {1} in front of it."},
                 {"early", "Old value: '{0}' is read ahead of '{1}' on line {2}.",
                  "Write G909 between them."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 T1
N2 G909
N3 #l7=#a1(Z,1)
N4 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 T1
N2 G904
N3 G909
N4 #l7=#a1(Z,1)
N5 M30
END
)nc"}},
    .sources = {"SEED-003:18081-18118", "SEED-003:18135-18141", "SEED-003:22318-22325"},
    .check = &check,
};

namespace {

/// Whether the code takes the value over: G904 all, G901 to G903 their own, G912 where the probe touched.
/// G905 the angle of the C axis.
bool fills(double code, int number) {
    if (number == 0 && code == 905) return true;
    return code == 904 || (number == 9 ? code == 912 : code >= 901 && code <= 903);
}

void look_at(const ProgramAnalysis& analysis, Span read, int number,
             const std::vector<queries::TextBlock>& blocks, Reporter& reporter) {
    const Program& program = analysis.program();
    const queries::TextBlock* filled = nullptr; // with nothing between that may stop the reading ahead
    // In a loop what stands behind the read comes before it, too.
    const bool is_repeated = analysis.regions().loop_around(program, read.begin).has_value();
    bool may_be_filled = false;
    for (const queries::TextBlock& block : blocks) {
        const auto code = block.code();
        if (block.block.span.begin >= read.begin) {
            if (!is_repeated) break;
            may_be_filled |= code && fills(*code, number);
        } else if (code && fills(*code, number)) {
            may_be_filled = true;
            filled = &block;
        } else if (block.block.span.end <= read.begin && (block.breaks || (code && *code > 900))) {
            filled = nullptr;
        }
    }
    if (!may_be_filled)
        reporter.report({analysis, read}, read, "empty",
                        {quoted(program, read), number == 9 ? "G912" : "G904"});
    else if (filled != nullptr && number != 9)
        reporter.report({analysis, read}, read, "early",
                        {quoted(program, read), quoted(program, filled->block.span),
                         line_number(analysis.file(), filled->block.span.begin)});
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const bool calls = std::ranges::any_of(program.effects, [](const Effect& effect) {
        return std::holds_alternative<Call>(effect.what) ||
               std::holds_alternative<UnreadableBlock>(effect.what);
    });
    if (!analysis.is_main() || calls) return; // another program may take the values over
    const Section* at = nullptr;
    std::optional<std::vector<queries::TextBlock>> blocks; // of that section
    for (const queries::ControlRead& read : queries::reads_of_control(program, "#a")) {
        const Section* section = section_at(program, read.span.begin);
        if (section == nullptr || section->executed != Section::Executed::when_reached) continue;
        if (section != at) blocks = queries::blocks_in_order(program, *section);
        at = section;
        if (blocks) look_at(analysis, read.span, read.number, *blocks, reporter);
    }
}

} // namespace
} // namespace maclint::rules
