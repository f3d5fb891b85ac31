//! MAC425: words in the block that returns from a program called after every move.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule words_beside_modal_return{
    .code = "MAC425",
    .name = "words-beside-m99-in-modal-call",
    .summary = "M99 shares its block with words while a modal macro call is active",
    .why = "While G66 is active, the block of M99 may hold no words but O, N, P and L: the control stops "
           "there, in "
           "the middle of the row of holes.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::modal_calls},
    .also = "MAC413",
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .messages =
        {{"called",
          "Words beside M99 in a modal call: '{0}' stands in its block, {1} calls this program by {2}, and "
          "newer controls stop here.",
          "Give '{0}' a block of its own, before M99."},
         {"active",
          "Words beside M99 in a modal call: '{0}' stands in its block while {1} is active, and newer "
          "controls stop here.",
          "Give '{0}' a block of its own, before M99."}},
    .bad = {{"fanuc", R"nc(
O0425(ROW)
G66 P9425 Z-20.
X10.
X20.
G67
M30
O9425(DRILL, Z)
G1 Z#26 F100.
G0 Z5. M99
)nc"},
            {"fanuc", R"nc(
O0425(ROW)
G66 P9426 Z-20.
X10.
X20. M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0425(ROW)
G66 P9425 Z-20.
X10.
X20.
G67
M30
O9425(DRILL, Z)
G1 Z#26 F100.
G0 Z5.
N9 M99
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "1093", "DUPLICATE NC-WORD & M99"}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

/// The first word that may not stand beside the return.
const Word* word_beside(const ControlModel& control, std::span<const Word> words) {
    constexpr std::string_view allowed = "ONPL";
    const auto found = std::ranges::find_if(words, [&](const Word& word) {
        return word.has_value() && !queries::ends_program(control, word) &&
               allowed.find(word.address) == std::string_view::npos;
    });
    return found == words.end() ? nullptr : &*found;
}

/// A call that runs the program after every move of another, or nullptr.
const Caller* modal_caller(const ProgramAnalysis& analysis) {
    const auto is_modal = [&](const Caller& caller) {
        const ProgramAnalysis& calling = queries::calling_program(analysis, caller);
        const Call& call = queries::call_of(calling.program(), caller.effect);
        return calling.control().calls[call.kind].trigger != CallTrigger::once;
    };
    const auto found = std::ranges::find_if(analysis.callers(), is_modal);
    return found == analysis.callers().end() ? nullptr : &*found;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    const auto group = control.group_with(ModalRole::macro_call);
    const bool stops = !reporter.alarm_for(analysis.file(), "called").empty();
    if (!group || (!stops && !control.assumed)) return; // of the other controls nothing is known
    const auto report = [&](const Word& word, std::string_view message, std::vector<std::string> arguments) {
        Finding& finding = reporter.report({analysis, word.span}, word.span, message, std::move(arguments));
        if (!stops) finding.severity = Severity::warning;
    };
    const Caller* caller = modal_caller(analysis);
    queries::ModesAt modes_at(analysis);
    for (const Item& item : program.items) {
        const auto* block = std::get_if<Block>(&item);
        if (block == nullptr ||
            std::ranges::none_of(program.effects_in(block->effects), [](const Effect& effect) {
                return std::holds_alternative<Return>(effect.what);
            }))
            continue;
        const auto words = std::span(program.words).subspan(block->words.first, block->words.count);
        const Word* word = word_beside(control, words);
        if (word == nullptr) continue;
        const std::string written = quoted(program, word->span);
        if (caller != nullptr) {
            const ProgramAnalysis& calling = queries::calling_program(analysis, *caller);
            const Span call = calling.program().effects[caller->effect].span;
            report(*word, "called", {written, place_in(calling, call), quoted(calling.program(), call)});
            continue;
        }
        const auto code = modes_at(blocks::view_of(program, *block)).with_words(*group).sure_code();
        if (code && code != control.groups[*group].cancel)
            report(*word, "active", {written, control.spell(*group, *code)});
    }
}

} // namespace
} // namespace maclint::rules
