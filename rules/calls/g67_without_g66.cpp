//! MAC414: a modal macro call is ended that was never begun.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption safety_block;
} // namespace

extern const Rule g67_without_g66{
    .code = "MAC414",
    .name = "g67-without-g66",
    .summary = "G67 ends a modal macro call, but none is active",
    .why = "Newer controls stop with an alarm, unless a parameter (6000#0) lets them pass over it. Often G65 "
           "was "
           "written for G66: the macro runs once, and not after every move up to G67.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::modal_calls},
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .messages =
        {{"once",
          "No modal call to end: '{0}' follows '{1}' on line {2}, which calls the macro once, and no G66.",
          "Write G66 there, or remove '{0}'."},
         {"none", "No modal call to end: none is active at '{0}'.", "Remove it.", true}},
    .bad = {{"fanuc", R"nc(
O0414(ROW)
G65 P9414 Z-20.
X10.
X20.
G67
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0414(ROW)
G17 G40 G49 G80 G90
G66 P9414 Z-20.
X10.
X20.
G67
M30
)nc"}},
    .exemptions =
        {{&safety_block,
          "safety-block",
          "G67 stands with other codes: the block makes sure that nothing of an earlier program is left.",
          {"fanuc", R"nc(
O0414(ROW)
G65 P9414 Z-20.
G0 Z50.
G40 G49 G67 G80
M30
)nc"}}},
    .alarms = {{"FANUC 30i/0i-D", "1100", "CANCEL WITHOUT MODAL CALL", false}},
    .sources = {"SEED-001:668-675", "CNCWIKI-CALL"},
    .check = &check,
};

namespace {

/// The last call before it that makes a macro run once, where the program makes no modal call.
const queries::CallInBlock* last_call_before(std::span<const queries::CallInBlock> calls, Offset at) {
    const queries::CallInBlock* last = nullptr;
    for (const queries::CallInBlock& call : calls) {
        if (call.kind.trigger != CallTrigger::once) return nullptr;
        if (call.passes_arguments() && call.block.begin < at) last = &call;
    }
    return last;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    const auto group = control.group_with(ModalRole::macro_call);
    if (!group || !control.groups[*group].cancel) return;
    const double off = *control.groups[*group].cancel;
    const std::vector<queries::CallInBlock> calls = queries::calls_with_words(analysis);
    queries::ModesAt modes_at(analysis);
    for_each_block_that_sets(program, *group, [&](const BlockView& block) {
        const auto cancels =
            std::ranges::find_if(program.effects_in(block.effects), [&](const Effect& effect) {
                const auto* set = std::get_if<SetModal>(&effect.what);
                if (set == nullptr || set->group != group) return false;
                const auto* code = std::get_if<Literal>(&program.expressions[set->value].node);
                return code != nullptr && code->value == off;
            });
        if (cancels == program.effects_in(block.effects).end()) return;
        const queries::Modes before = modes_at(block).before(*group);
        if (safety_block.is_on() && program.effects_in(block.effects).size() != 1) return;
        const Span span = cancels->span;
        const queries::CallInBlock* call = last_call_before(calls, span.begin);
        if (before.sure_code() != off && (call == nullptr || !analysis.is_main())) return;
        const std::string written = quoted(program, span);
        if (call == nullptr) {
            // It ends nothing.
            offer_removal(reporter.report({analysis, span}, span, "none", {written}), Applicability::safe,
                          span);
            return;
        }
        reporter.report({analysis, span}, span, "once",
                        {written, quoted(program, call->code_word().span),
                         line_number(analysis.file(), call->block.begin)});
    });
}

} // namespace
} // namespace maclint::rules
