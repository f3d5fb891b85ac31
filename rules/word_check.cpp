//! The pass over the words.
#include "rules/word_check.hpp"

#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

namespace maclint {
namespace {

/// A rule that takes part in the pass.
struct Taking {
    const WordCheck* check;
    Reporter reporter;
};

/// Which blocks the rules can want, told from what is known of them without their words.
class Wanted {
  public:
    Wanted(const Program& program, std::span<const Taking> rules) {
        for (const Taking& rule : rules) {
            const syntax::AddressSet addresses = addresses_named(program, rule.check->addresses);
            switch (rule.check->blocks) {
            case WordCheck::Blocks::all: any_.add(addresses); break;
            case WordCheck::Blocks::repeated: repeated_.add(addresses); break;
            case WordCheck::Blocks::conflicting: conflicting_.add(addresses); break;
            }
        }
    }

    [[nodiscard]] bool operator()(const WordSummary& words) const {
        return words.addresses.meets(any_) || words.repeated.meets(repeated_) ||
               (words.conflicts && words.addresses.meets(conflicting_));
    }

  private:
    syntax::AddressSet any_;
    syntax::AddressSet repeated_;
    syntax::AddressSet conflicting_;
};

bool has_modal_calls(const Program& program) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* call = std::get_if<Call>(&effect.what);
        return call != nullptr && program.control->calls[call->kind].trigger != CallTrigger::once;
    });
}

} // namespace

bool has_alternatives(const WordsOfBlock& block) {
    return std::ranges::any_of(
        block.analysis.program().effects_in(block.block.effects),
        [](const Effect& effect) { return std::holds_alternative<Guarded>(effect.what); });
}

bool may_call(const WordsOfBlock& block) {
    const Program& program = block.analysis.program();
    const ControlModel& control = block.analysis.control();
    const auto calls = [](const Effect& effect) { return std::holds_alternative<Call>(effect.what); };
    if (std::ranges::any_of(program.effects_in(block.block.effects), calls)) return true;
    const auto unknown = [&](const Word& word) {
        if (word.address != "G" && word.address != "M") return false;
        const auto* code = std::get_if<Literal>(&word.value);
        return code == nullptr || !control.group_of(word.address.front(), code->value);
    };
    return block.modal_calls || std::ranges::any_of(block.words, unknown);
}

std::vector<Finding> check_words(const ProgramAnalysis& analysis, std::span<const Rule* const> rules) {
    std::vector<Taking> taking;
    for (const Rule* rule : rules)
        if (const auto* check = std::get_if<WordCheck>(&rule->check))
            taking.push_back({check, Reporter(*rule)});
    if (taking.empty()) return {};
    const Program& program = analysis.program();
    const bool modal_calls = has_modal_calls(program);
    for_each_block_with_words(program, Wanted(program, taking),
                              [&](const BlockView& block, std::span<const Word> words) {
                                  for (Taking& rule : taking)
                                      rule.check->check({analysis, block, words, modal_calls}, rule.reporter);
                              });
    std::vector<Finding> findings;
    for (Taking& rule : taking) std::ranges::move(rule.reporter.take(), std::back_inserter(findings));
    return findings;
}

} // namespace maclint
