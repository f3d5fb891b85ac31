//! One workspace, one run of the union of all selections, then every file's own judgement.
#include "cli/lint.hpp"

#include "cli/words.hpp"

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
        complete = complete && file.settings.configuration && file.settings.configuration->complete;
    }
    return Workspace::analyse(std::move(members), {complete, jobs});
}

/// What any file wants; each file drops what it did not.
Selection selection_of(const std::vector<ReadFile>& files) {
    std::vector<const RuleStates*> states;
    for (const ReadFile& file : files)
        if (file.file && file.input.asked) states.push_back(file.settings.rules.get());
    std::ranges::sort(states);
    states.erase(std::ranges::unique(states).begin(), states.end());
    Selection selection;
    for (const Rule* rule : all_rules())
        if (std::ranges::any_of(states, [rule](const RuleStates* all) { return all->of(*rule).on; }))
            selection.rules.push_back(rule);
    return selection;
}

void report_not_nc(const std::vector<ReadFile>& files, std::vector<Finding>& findings) {
    Reporter reporter(*find_rule("MAC003"));
    for (const ReadFile& file : files)
        if (file.not_nc) reporter.report(*file.file, {0, 0}, "not-nc", {*file.not_nc});
    std::ranges::move(reporter.take(), std::back_inserter(findings));
}

/// A configuration file seen as a program file, so that findings have a place in it.
std::shared_ptr<const ProgramFile> as_file(const Source& source) {
    auto file = std::make_shared<ProgramFile>();
    file->source = std::make_shared<const Source>(source);
    file->control = controls().front();
    return file;
}

void check_configuration(const Configuration& configuration, const RuleStates& states, LintResult& result) {
    std::vector<FileRules> files;
    for (const Source& source : configuration.sources) {
        result.kept.push_back(as_file(source));
        files.push_back({result.kept.back().get(), &states});
    }
    Reporter reporter(*find_rule("MAC002"));
    for (const RuleWord* word : configuration.rule_words()) {
        if (!rules_named(word->word).empty()) continue;
        const auto similar = closest(word->word, rule_words());
        auto arguments = similar ? std::vector{word->word, *similar} : std::vector{word->word};
        reporter.report(*files[word->source].file, word->span, similar ? "similar" : "unknown",
                        std::move(arguments));
    }
    std::ranges::move(judge(reporter.take(), files), std::back_inserter(result.findings));
}

} // namespace

LintResult lint(const std::vector<ReadFile>& files, Settings& settings, unsigned jobs, Progress& progress) {
    LintResult result;
    progress.begin("following the programs", 0);
    result.workspace = analyse(files, jobs);
    progress.begin("checking", 0);
    auto findings = run_rules(*result.workspace, selection_of(files), jobs);
    report_not_nc(files, findings);
    std::vector<FileRules> judged;
    for (const ReadFile& file : files) {
        if (!file.file || !file.input.asked) continue;
        judged.push_back({file.file.get(), file.settings.rules.get()});
        if (file.not_nc) result.kept.push_back(file.file);
    }
    result.findings = judge(std::move(findings), judged);
    for (const auto& configuration : settings.configurations())
        if (const auto own = settings.for_file(configuration->path))
            check_configuration(*configuration, *own->rules, result);
    std::ranges::stable_sort(result.findings, comes_before, &JudgedFinding::finding);
    return result;
}

} // namespace maclint::cli
