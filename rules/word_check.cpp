//! The pass over the words.
#include "rules/word_check.hpp"

#include "analyzer/program/lines_with.hpp"
#include "analyzer/queries/machine/switches_at.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/words/arcs_going_on.hpp"
#include "rules/words/row_indexes.hpp"
#include "rules/words/row_pass.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

namespace maclint {
namespace {

/// A rule that takes part in the pass.
struct Taking {
    const WordCheck* check;
    syntax::AddressSet addresses; ///< that it looks at
    Reporter reporter;

    /// Whether it can find anything in blocks of which this is known.
    [[nodiscard]] bool wants(const WordSummary& words) const {
        switch (check->blocks) {
        case WordCheck::Blocks::all: return words.addresses.meets(addresses);
        case WordCheck::Blocks::repeated: return words.repeated.meets(addresses);
        case WordCheck::Blocks::conflicting: return words.conflicts && words.addresses.meets(addresses);
        }
        return true;
    }
};

} // namespace

std::vector<Finding> check_words(const ProgramAnalysis& analysis, std::span<const Rule* const> rules,
                                 const RowIndexes& rows) {
    const Program& program = analysis.program();
    std::vector<Taking> taking;
    for (const Rule* rule : rules)
        if (const auto* check = std::get_if<WordCheck>(&rule->check);
            check != nullptr && applies_to(*rule, analysis.control()))
            taking.push_back({check, addresses_named(program, check->addresses), Reporter(*rule)});
    RowPass row_pass(rules);
    queries::ModesAt modes_at(analysis);
    queries::SwitchesAt switches_at(analysis);
    const bool modal_calls = queries::has_modal_calls(program);
    const auto rule_wants = [&](const WordSummary& words) {
        return std::ranges::any_of(taking, [&](const Taking& rule) { return rule.wants(words); });
    };
    for (const Section& section : program.sections) {
        const RowIndex& index = rows.of(program, section);
        if (taking.empty() && index.empty()) continue;
        ArcsGoingOn arcs(analysis, index);
        bool only_arcs = false;
        const auto is_idle_in = [&](const PlainRun& run) {
            return [&](const WordRow& row) {
                return !switches_at.may_hold_in(run, section, row.while_on, row.while_off);
            };
        };
        for_each_block_with_words(
            program, section.items,
            [&](const PlainRun& run, const auto& take) {
                if (rule_wants(run.words))
                    take(run.span);
                else if (const auto codes = index.codes_wanted(program, run, is_idle_in(run)); !codes.empty())
                    for_each_line_with(codes, program.text, run.span, take); // few lines of CAM output
                only_arcs = true;
                arcs.for_each_line(run, take);
                only_arcs = false;
            },
            [&](const WordSummary& block) {
                return only_arcs || rule_wants(block) || index.wants_block(block);
            },
            [&](const BlockView& block, std::span<const Word> words, const WordSummary* summary) {
                const queries::WordsOfBlock with_words{analysis, block,    words,      modal_calls,
                                                       section,  modes_at, switches_at};
                if (only_arcs || summary == nullptr) arcs.look_at(with_words, row_pass);
                if (only_arcs) return;
                for (Taking& rule : taking)
                    if (summary == nullptr || rule.wants(*summary))
                        rule.check->check(with_words, rule.reporter);
                row_pass.look_at(with_words, index);
            });
    }
    std::vector<Finding> findings;
    for (Taking& rule : taking) std::ranges::move(rule.reporter.take(), std::back_inserter(findings));
    std::ranges::move(row_pass.take(), std::back_inserter(findings));
    return findings;
}

} // namespace maclint
