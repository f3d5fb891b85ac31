//! Runs rules over a workspace, files in parallel.
#include "analyzer/workspace/parallel.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <iterator>

namespace maclint {
namespace {

/// Runs every rule of one kind of check over `things`, each thing's findings into a place of its own.
template<class Check, class Thing>
void run_checks(const Selection& selection, const Thing& thing, std::vector<Finding>& findings) {
    for (const Rule* rule : selection.rules) {
        const auto* check = std::get_if<Check>(&rule->check);
        if (check == nullptr) continue;
        Reporter reporter(*rule);
        (*check)(thing, reporter);
        std::ranges::move(reporter.take(), std::back_inserter(findings));
    }
}

} // namespace

std::vector<Finding> run_rules(const Workspace& workspace, const Selection& selection, unsigned jobs) {
    std::vector<const ProgramFile*> files;
    for (const WorkspaceFile& file : workspace.files())
        if (file.asked) files.push_back(file.file.get());
    std::vector<const ProgramAnalysis*> programs;
    for (const ProgramAnalysis& program : workspace.programs())
        if (program.asked()) programs.push_back(&program);

    std::vector<std::vector<Finding>> parts(files.size() + programs.size() + 1);
    for_each_parallel(parts.size(), jobs, [&](std::size_t i) {
        if (i < files.size()) return run_checks<FileCheck>(selection, *files[i], parts[i]);
        i -= files.size();
        if (i < programs.size())
            return run_checks<ProgramCheck>(selection, *programs[i], parts[files.size() + i]);
        run_checks<WorkspaceCheck>(selection, workspace, parts.back());
    });

    std::vector<Finding> findings;
    for (auto& part : parts) std::ranges::move(part, std::back_inserter(findings));
    std::ranges::sort(files);
    std::erase_if(findings,
                  [&](const Finding& finding) { return !std::ranges::binary_search(files, finding.file); });
    std::ranges::stable_sort(findings, comes_before);
    return findings;
}

} // namespace maclint
