//! Puts what is left on into words.
#include "rules/dinplus/left_active.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/left_active.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "rules/fixes.hpp"
#include "rules/modal/modal_leak.hpp"

namespace maclint::rules {

std::vector<std::string> words_of(const ProgramAnalysis& analysis, GroupId id, double code) {
    const ModalGroup& group = analysis.control().groups[id];
    return {analysis.control().spell(id, code), std::string(group.cancel_words)};
}

void report_left_at_end(const ProgramAnalysis& analysis, ModalRole role, Reporter& reporter) {
    const auto leak = queries::left_at_end(analysis, role);
    if (!leak) return;
    const std::vector<std::string> words =
        words_of(analysis, leak->group, *queries::own_code(analysis, leak->part));
    Finding& finding = report_leak(analysis, reporter, *leak, words);
    const bool is_block = words[1].find('(') == std::string::npos; // else it says which of several
    if (is_block && leak->exit->exit.kind != flow::ExitKind::runs_off)
        offer_block_before(finding, Applicability::unsafe, queries::span_of_exit(analysis, leak->exit->exit),
                           words[1]);
}

} // namespace maclint::rules
