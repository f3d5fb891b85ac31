//! Runs rules over a workspace, files in parallel.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/parallel.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"
#include "rules/bounds_met.hpp"
#include "rules/finding_order.hpp"
#include "rules/findings_in.hpp"
#include "rules/rule.hpp"
#include "rules/words/row_indexes.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace maclint {
namespace {

const std::string& path_of(const ProgramAnalysis& program) { return program.source()->path(); }

/// Jumps or returns of the program share a node from which all labels are reached: its edges belong to none.
bool shares_labels(const ProgramAnalysis& program) {
    return std::ranges::any_of(program.graph().edges, [](const flow::Edge& edge) {
        const bool any = edge.kind == flow::EdgeKind::computed || edge.kind == flow::EdgeKind::resume;
        return any && !edge.jump;
    });
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
    return run_rules(workspace, selection, jobs, met, {});
}

std::vector<Finding> run_rules(const Workspace& workspace, const Selection& selection, unsigned jobs,
                               std::vector<BoundMet>& met, const std::stop_token& stop) {
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
            parts[i] = findings_in(with_rows, *files[i], bounds[i], stop);
        } else {
            const ProgramAnalysis& program = *programs[i - files.size()];
            parts[i] = findings_in(with_rows, program, bounds[i], stop);
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
