//! One workspace, one run of the union of all selections, then every file's own judgement.
#include "cli/lint.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::cli {
namespace {

std::unique_ptr<Workspace> analyse(const std::vector<ReadFile>& files, unsigned jobs) {
    std::vector<WorkspaceFile> members;
    bool complete = true;
    for (const ReadFile& file : files) {
        if (!file.file || file.not_nc) continue;
        members.push_back({file.file, file.input.asked});
        complete = complete && file.settings.complete;
    }
    return Workspace::analyse(std::move(members), {complete, jobs});
}

/// What any file wants, or needs to have its suppressions judged; each file drops what it did not want.
Selection selection_of(const std::vector<ReadFile>& files) {
    const Rule& unused_suppression = *find_rule("MAC001");
    std::vector<bool> wanted(all_rules().size());
    std::vector<const RuleStates*> seen;
    for (const ReadFile& file : files) {
        if (!file.file || !file.input.asked) continue;
        const RuleStates& states = *file.settings.rules;
        if (states.of(unused_suppression).on)
            for (const Rule* rule : rules_in_suppressions(*file.file))
                wanted[RuleStates::index_of(*rule)] = true;
        if (std::ranges::find(seen, &states) != seen.end()) continue;
        seen.push_back(&states);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (states.all()[i].on) wanted[i] = true;
    }
    Selection selection;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i]) selection.rules.push_back(all_rules()[i]);
    return selection;
}

void report_not_nc(const std::vector<ReadFile>& files, std::vector<Finding>& findings) {
    Reporter reporter(*find_rule("MAC003"));
    for (const ReadFile& file : files)
        if (file.not_nc) reporter.report({*file.file, {0, 0}}, {0, 0}, "not-nc", {*file.not_nc});
    std::ranges::move(reporter.take(), std::back_inserter(findings));
}

} // namespace

LintResult lint(const std::vector<ReadFile>& files, unsigned jobs, Progress& progress) {
    progress.begin("following the programs", 0);
    const auto workspace = analyse(files, jobs);
    progress.begin("checking", 0);
    auto findings = run_rules(*workspace, selection_of(files), jobs);
    report_not_nc(files, findings);
    std::vector<FileRules> filtered;
    for (const ReadFile& file : files) {
        if (!file.file || !file.input.asked) continue;
        filtered.push_back({file.file.get(), file.settings.rules.get()});
    }
    LintResult result{apply_suppressions(std::move(findings), filtered)};
    std::ranges::stable_sort(result.findings, comes_before, &FilteredFinding::finding);
    return result;
}

} // namespace maclint::cli
