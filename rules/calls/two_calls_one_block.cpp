//! MAC423: two codes of one block that call or end a program.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule two_calls_one_block{
    .code = "MAC423",
    .name = "two-calls-one-block",
    .summary = "A block calls two programs, or calls one and ends its own or begins a cycle",
    .why =
        "A block has one P, and the control goes to one place when it ends: of two calls one is lost, or it "
        "stops. A code that ends the program is an argument where it stands after a macro call.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::macro_calls},
    .messages = {{"macro", "Two macro calls in one block: '{0}' and '{1}'.",
                  "Give each call a block of its own."},
                 {"sub", "Two subprogram calls in one block: '{0}' and '{1}', with one P for both.",
                  "Give each call a block of its own."},
                 {"end",
                  "A call and an end in one block: '{0}' beside '{1}', and the control does one of them.",
                  "Give each a block of its own."},
                 {"cycle", "A macro call and a cycle in one block: '{0}' and '{1}' share words.",
                  "Give each a block of its own."},
                 {"passed",
                  "End of a program as an argument: after '{0}', '{1}' passes a value that {2} does not "
                  "read, and ends nothing.",
                  "Give it a block of its own."}},
    .bad = {{"fanuc", R"nc(
O0423(PLATE)
G65 P9423 X10. G65 P9423 X20.
M30
O9423(HOLE, X)
G0 X#24
M99
)nc"},
            {"fanuc", R"nc(
O0423(PLATE)
M98 P1423 M98 P1423
M30
O1423(STEP)
G90 X10.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0423(PLATE)
G65 P9423 X10.
G65 P9423 X20. M8
M98 P1423
M30
O9423(HOLE, X M)
G0 X#24
M#13
M99
O1423(STEP)
G91 X10.
G90
M99
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "1092", "DUPLICATE MACRO-CALL WORD", true, "macro"},
               {"FANUC 30i/0i-D", "1091", "DUPLICATE SUB-CALL WORD", true, "sub"},
               {"FANUC 16i/18i/21i", "129", "ILLEGAL ARGUMENT ADDRESS", true, "macro"}},
    .sources = {"GH-ALM", "CNCWIKI-CALL"},
    .check = &check,
};

namespace {

class BlockCheck {
  public:
    BlockCheck(const ProgramAnalysis& analysis, Reporter& reporter)
        : analysis_(analysis)
        , reporter_(reporter) {}

    void look_at(const queries::CallInBlock* before, const queries::CallInBlock& call) {
        if (before != nullptr && before->block == call.block) {
            if (before->passes_arguments() == call.passes_arguments())
                report(call.code_word(), call.passes_arguments() ? "macro" : "sub", before->code_word(), "");
            return;
        }
        for (const Word& word : call.words)
            if (queries::ends_program(analysis_.control(), word)) end(call, word);
        for (const Word& word : call.before()) // one after it is MAC404's
            if (call.passes_arguments() && queries::begins_cycle(analysis_.control(), word))
                report(word, "cycle", call.code_word(), "");
    }

  private:
    void end(const queries::CallInBlock& call, const Word& word) {
        if (!call.passes_arguments() || word.span.begin < call.code_word().span.begin)
            return report(word, "end", call.code_word(), "");
        const CallSite* site = analysis_.call_at(call.effect);
        const ProgramAnalysis* called = site == nullptr ? nullptr : queries::called_program(analysis_, *site);
        const Argument* argument = queries::argument_of(analysis_.program(), call, word);
        const auto* given = argument == nullptr ? nullptr : std::get_if<Variable>(&argument->given);
        if (called == nullptr || given == nullptr) return;
        const auto read = called->liveness().live_before(0);
        if (std::ranges::find(read, *given) == read.end())
            report(word, "passed", call.code_word(), called->program().name);
    }

    /// Only what an alarm of the control stands for is certain to stop it.
    void report(const Word& word, std::string_view message, const Word& other, const std::string& called) {
        const auto text = [&](const Word& one) { return quoted(analysis_.program(), one.span); };
        Finding& finding =
            reporter_.report({analysis_, word.span}, word.span, message, {text(other), text(word), called});
        if (finding.alarm.empty()) finding.severity = std::min(finding.severity, Severity::warning);
    }

    const ProgramAnalysis& analysis_;
    Reporter& reporter_;
};

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    BlockCheck block(analysis, reporter);
    const std::vector<queries::CallInBlock> calls = queries::calls_with_words(analysis);
    for (std::size_t i = 0; i < calls.size(); ++i) block.look_at(i == 0 ? nullptr : &calls[i - 1], calls[i]);
}

} // namespace
} // namespace maclint::rules
