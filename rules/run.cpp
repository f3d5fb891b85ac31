//! Runs rules over a workspace, files in parallel.
#include "analyzer/workspace/parallel.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"
#include "rules/word_check.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>

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

std::vector<Finding> check_words(const Selection&, const ProgramFile&) { return {}; }
std::vector<Finding> check_words(const Selection& selection, const ProgramAnalysis& program) {
    return check_words(program, selection.rules);
}

const ControlModel& control_of(const ProgramFile& file) { return *file.control; }
const ControlModel& control_of(const ProgramAnalysis& program) { return program.control(); }

Severity one_less(Severity severity) {
    return severity == Severity::error ? Severity::warning : Severity::note;
}

/// Everything that the selected rules find in a file or a program.
template<class Thing>
std::vector<Finding> check(const Selection& selection, const Thing& thing) {
    std::vector<Finding> findings;
    for (const Rule* rule : selection.rules) {
        if (!applies_to(*rule, control_of(thing))) continue;
        Reporter reporter(*rule);
        run_check(*rule, thing, reporter);
        for (Finding& finding : reporter.take()) {
            const Proof proof = rule->stands_without_path ? Proof::path : finding.proof;
            if (proof == Proof::no_path) continue;
            if (proof == Proof::gave_up) finding.severity = one_less(finding.severity);
            findings.push_back(std::move(finding));
        }
    }
    std::ranges::move(check_words(selection, thing), std::back_inserter(findings));
    return findings;
}

} // namespace

dataflow::FactSet facts_for(const Rule& rule) {
    constexpr dataflow::FactSet of_paths = dataflow::facts<dataflow::Store, dataflow::Clobber>();
    return rule.data_flow ? rule.facts | of_paths : rule.facts;
}

dataflow::FactSet facts_for(const Selection& selection) {
    dataflow::FactSet facts;
    for (const Rule* rule : selection.rules) facts |= facts_for(*rule);
    return facts;
}

std::vector<Finding> run_rules(const Workspace& workspace, const Selection& selection, unsigned jobs) {
    std::vector<const ProgramFile*> files;
    for (const WorkspaceFile& file : workspace.files())
        if (file.asked) files.push_back(file.file.get());
    std::vector<const ProgramAnalysis*> programs;
    for (const ProgramAnalysis& program : workspace.programs())
        if (program.asked()) programs.push_back(&program);

    std::vector<std::vector<Finding>> parts(files.size() + programs.size());
    for_each_parallel(parts.size(), jobs, [&](std::size_t i) {
        if (i < files.size()) {
            parts[i] = check(selection, *files[i]);
        } else {
            const ProgramAnalysis& program = *programs[i - files.size()];
            parts[i] = check(selection, program);
            program.search_memory().forget();
        }
    });

    std::vector<Finding> findings;
    for (auto& part : parts) std::ranges::move(part, std::back_inserter(findings));
    std::unordered_set<const Source*> asked;
    for (const ProgramFile* file : files) asked.insert(file->source.get());
    std::erase_if(findings, [&](const Finding& finding) { return !asked.contains(finding.source.get()); });
    std::ranges::stable_sort(findings, comes_before);
    return findings;
}

} // namespace maclint
