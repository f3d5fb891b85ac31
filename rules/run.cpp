//! Runs rules over a workspace, files in parallel.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/execution/given_up.hpp"
#include "analyzer/source/work_limit.hpp"
#include "analyzer/workspace/parallel.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"
#include "rules/bounds_met.hpp"
#include "rules/exemptions.hpp"
#include "rules/finding_order.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"
#include "rules/word_check.hpp"
#include "rules/words/row_indexes.hpp"
#include "rules/work_for.hpp"

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

const std::string& path_of(const ProgramFile& file) { return file.source->path(); }
const std::string& path_of(const ProgramAnalysis& program) { return program.source()->path(); }

/// Jumps or returns of the program share a node from which all labels are reached: its edges belong to none.
bool shares_labels(const ProgramAnalysis& program) {
    return std::ranges::any_of(program.graph().edges, [](const flow::Edge& edge) {
        const bool any = edge.kind == flow::EdgeKind::computed || edge.kind == flow::EdgeKind::resume;
        return any && !edge.jump;
    });
}

std::vector<Finding> check_words(const Selection&, const ProgramFile&) { return {}; }
std::vector<Finding> check_words(const Selection& selection, const ProgramAnalysis& program) {
    return check_words(program, selection.rules, *selection.rows);
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
    const execution::GivenUp given_up;
    const WorkLimit limit(work_for(thing));
    run_check(rule, thing, reporter);
    if ((given_up.any() && !rule.stands_without_path) || limit.is_met())
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
            return std::holds_alternative<WordCheck>(rule->check)
                       ? check_words(Selection{.rules = {rule}, .rows = selection.rows}, thing)
                       : check(*rule, thing, not_told);
        };
        std::ranges::move(withheld_findings(*rule, off_in(selection.exemptions, *rule), find),
                          std::back_inserter(withheld));
    }
    return withheld;
}

/// Everything that the selected rules find in a file or a program.
template<class Thing>
std::vector<Finding> check(const Selection& selection, const Thing& thing, std::vector<BoundMet>& met) {
    std::vector<Finding> findings;
    std::vector<const Exemption*> off_in_words; // those rules share a pass
    for (const Rule* rule : selection.rules) {
        if (!applies_to(*rule, control_of(thing))) continue;
        const auto off = exemptions_of(*rule, off_in(selection.exemptions, *rule));
        if (std::holds_alternative<WordCheck>(rule->check))
            std::ranges::copy(off, std::back_inserter(off_in_words));
        const WithoutExemptions without(off);
        std::ranges::move(check(*rule, thing, met), std::back_inserter(findings));
    }
    const WithoutExemptions without(off_in_words);
    std::ranges::move(check_words(selection, thing), std::back_inserter(findings));
    if (selection.exemptions.withheld == Withheld::listed)
        std::ranges::move(withheld_in(selection, thing), std::back_inserter(findings));
    return findings;
}

} // namespace

dataflow::FactSet facts_for(const Rule& rule) {
    constexpr dataflow::FactSet of_paths = dataflow::facts<dataflow::Store, dataflow::Clobber>();
    const bool asks_for_modes = std::ranges::any_of(rows_of(rule), [](const RuleRow& row) {
        return std::ranges::any_of(
            row.rows, [](const RowForCode& one) { return one.row->kept || !one.row->under.empty(); });
    });
    dataflow::FactSet facts = rule.facts;
    if (rule.data_flow) facts |= of_paths;
    if (asks_for_modes) facts |= dataflow::facts<dataflow::BeforeNode>();
    return facts;
}

dataflow::FactSet facts_for(const Selection& selection) {
    dataflow::FactSet facts;
    for (const Rule* rule : selection.rules) facts |= facts_for(*rule);
    return facts;
}

std::vector<Finding> run_rules(const Workspace& workspace, const Selection& selection, unsigned jobs) {
    std::vector<BoundMet> met;
    return run_rules(workspace, selection, jobs, met);
}

std::vector<Finding> run_rules(const Workspace& workspace, const Selection& selection, unsigned jobs,
                               std::vector<BoundMet>& met) {
    Selection with_rows = selection;
    if (with_rows.rows == nullptr) with_rows.rows = RowIndexes::of_all(selection.rules);
    std::vector<const ProgramFile*> files;
    for (const WorkspaceFile& file : workspace.files())
        if (file.asked) files.push_back(file.file.get());
    std::vector<const ProgramAnalysis*> programs;
    for (const ProgramAnalysis& program : workspace.programs())
        if (program.asked()) programs.push_back(&program);

    std::vector<std::vector<Finding>> parts(files.size() + programs.size());
    std::vector<std::vector<BoundMet>> bounds(parts.size());
    for_each_parallel(parts.size(), jobs, [&](std::size_t i) {
        if (i < files.size()) {
            parts[i] = check(with_rows, *files[i], bounds[i]);
        } else {
            const ProgramAnalysis& program = *programs[i - files.size()];
            parts[i] = check(with_rows, program, bounds[i]);
            if (shares_labels(program)) bounds[i].push_back({path_of(program), {}});
            program.search_memory().forget();
        }
    });

    std::vector<Finding> findings;
    for (auto& part : parts) std::ranges::move(part, std::back_inserter(findings));
    for (auto& part : bounds) std::ranges::move(part, std::back_inserter(met));
    std::unordered_set<const Source*> asked;
    for (const ProgramFile* file : files) asked.insert(file->source.get());
    std::erase_if(findings, [&](const Finding& finding) { return !asked.contains(finding.source.get()); });
    put_in_order(findings);
    return findings;
}

} // namespace maclint
