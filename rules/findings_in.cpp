//! Runs the selected rules over one file or program, and what exemptions hold back with them off.
#include "rules/findings_in.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/source/budget.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/machine_check.hpp"
#include "rules/syntax_errors.hpp"
#include "rules/withheld.hpp"
#include "rules/word_check.hpp"
#include "rules/work_for.hpp"

#include <iterator>

namespace maclint {
namespace {

void run_check(const Rule& rule, const ProgramFile& file, Reporter& reporter) {
    if (const auto* syntax_error = std::get_if<SyntaxErrorKind>(&rule.check))
        report_syntax_error(file, *syntax_error, reporter);
    if (const auto* check = std::get_if<FileCheck>(&rule.check)) (*check)(file, reporter);
}

void run_check(const Rule& rule, const ProgramAnalysis& program, Reporter& reporter) {
    if (const auto* check = std::get_if<ProgramCheck>(&rule.check)) (*check)(program, reporter);
}

const std::string& path_of(const ProgramFile& file) { return file.source->path(); }
const std::string& path_of(const ProgramAnalysis& program) { return program.source()->path(); }

/// The rules that share a pass over blocks.
std::vector<Finding> check_blocks(const Selection&, const ProgramFile&) { return {}; }
std::vector<Finding> check_blocks(const Selection& selection, const ProgramAnalysis& program) {
    std::vector<Finding> findings = check_words(program, selection.rules, *selection.rows);
    std::ranges::move(check_machine(program, selection.rules), std::back_inserter(findings));
    return findings;
}

bool shares_pass(const Rule& rule) {
    return std::holds_alternative<WordCheck>(rule.check) || std::holds_alternative<MachineCheck>(rule.check);
}

const ControlModel& control_of(const ProgramFile& file) { return *file.control; }
const ControlModel& control_of(const ProgramAnalysis& program) { return program.control(); }

Severity one_less(Severity severity) {
    return severity == Severity::error ? Severity::warning : Severity::note;
}

/// What one rule finds in a file or a program by itself.
template<class Thing>
std::vector<Finding> check(const Rule& rule, const Thing& thing, std::vector<BoundMet>& met) {
    std::vector<Finding> findings;
    Reporter reporter(rule);
    const Budget budget(work_for(thing));
    run_check(rule, thing, reporter);
    if ((budget.gave_up() && !rule.stands_without_path) || budget.is_spent())
        met.push_back({path_of(thing), rule.code});
    for (Finding& finding : reporter.take()) {
        const Proof proof = rule.stands_without_path ? Proof::path : finding.proof;
        if (proof == Proof::no_path) continue;
        if (proof == Proof::gave_up) finding.severity = one_less(finding.severity);
        findings.push_back(std::move(finding));
    }
    return findings;
}

/// What exemptions of the selected rules hold back.
template<class Thing>
std::vector<Finding> withheld_in(const Selection& selection, const Thing& thing) {
    std::vector<Finding> withheld;
    for (const Rule* rule : selection.rules) {
        if (rule->exemptions.empty() || !applies_to(*rule, control_of(thing))) continue;
        const auto find = [&](ExemptionBits off) {
            const auto exemptions = exemptions_of(*rule, off);
            const WithoutExemptions without(exemptions);
            std::vector<BoundMet> not_told;
            return shares_pass(*rule)
                       ? check_blocks(Selection{.rules = {rule}, .rows = selection.rows}, thing)
                       : check(*rule, thing, not_told);
        };
        std::ranges::move(withheld_findings(*rule, off_in(selection.exemptions, *rule), find),
                          std::back_inserter(withheld));
    }
    return withheld;
}

template<class Thing>
std::vector<Finding> find(const Selection& selection, const Thing& thing, std::vector<BoundMet>& met,
                          const std::stop_token& stop) {
    std::vector<Finding> findings;
    std::vector<const Exemption*> off_in_blocks; // those rules share a pass
    for (const Rule* rule : selection.rules) {
        if (stop.stop_requested()) return {};
        if (!applies_to(*rule, control_of(thing))) continue;
        const auto off = exemptions_of(*rule, off_in(selection.exemptions, *rule));
        if (shares_pass(*rule)) std::ranges::copy(off, std::back_inserter(off_in_blocks));
        const WithoutExemptions without(off);
        std::ranges::move(check(*rule, thing, met), std::back_inserter(findings));
    }
    const WithoutExemptions without(off_in_blocks);
    std::ranges::move(check_blocks(selection, thing), std::back_inserter(findings));
    if (selection.exemptions.withheld == Withheld::listed)
        std::ranges::move(withheld_in(selection, thing), std::back_inserter(findings));
    return findings;
}

} // namespace

std::vector<Finding> findings_in(const Selection& selection, const ProgramFile& file,
                                 std::vector<BoundMet>& met, const std::stop_token& stop) {
    return find(selection, file, met, stop);
}

std::vector<Finding> findings_in(const Selection& selection, const ProgramAnalysis& program,
                                 std::vector<BoundMet>& met, const std::stop_token& stop) {
    return find(selection, program, met, stop);
}

} // namespace maclint
