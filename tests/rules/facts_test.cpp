//! Every rule asks for the facts that its record declares: no others, and none in vain.
#include "analyzer/dataflow/facts/fact_lists.hpp"
#include "analyzer/program/model.hpp"
#include "cli/engine/read.hpp"
#include "cli/input/discover.hpp"
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <typeinfo>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using dataflow::FactSet;

/// The types by the names that the compiler has for them.
template<class... Types>
struct Spelled {
    static std::string of(FactSet facts) {
        std::string text;
        ((text += facts.has<Types>() ? std::string(typeid(Types).name()) + " " : ""), ...);
        return text;
    }
};

std::string spell(FactSet facts) { return dataflow::OfEveryFact<Spelled>::of(facts); }

std::vector<WorkspaceFile> read_all(const cli::Snapshot& snapshot) {
    std::vector<WorkspaceFile> members;
    cli::ProgramStore store(0);
    for (const cli::SnapshotFile& file : snapshot.files) {
        auto opened = cli::open_file(file);
        if (!std::holds_alternative<Source>(opened)) continue;
        auto source = std::make_shared<const Source>(std::get<Source>(std::move(opened)));
        if (auto programs = cli::read_source(file, std::move(source), Extent::whole, store).file)
            members.push_back({std::move(programs), true});
    }
    return members;
}

using Folders = std::vector<std::vector<WorkspaceFile>>;

/// All programs of the corpus, each of its folders as one workspace.
const Folders& corpus() {
    static const auto all = [] {
        Folders folders;
        for (const auto& entry : fs::directory_iterator(fs::path(MACLINT_SOURCE_DIR) / "corpus")) {
            cli::Settings settings({});
            auto found = cli::discover({entry.path().string()}, "stdin.nc", settings);
            folders.push_back(read_all(cli::snapshot_of(std::move(found.files), settings)));
        }
        return folders;
    }();
    return all;
}

/// The examples of each rule, each a workspace.
const std::vector<Folders>& examples() {
    static const auto all = [] {
        std::vector<Folders> rules;
        for (const Rule* rule : all_rules()) {
            Folders& folders = rules.emplace_back();
            for (const auto* examples : {&rule->bad, &rule->good}) {
                for (const Example& example : *examples) {
                    cli::Overrides overrides;
                    overrides.dialect = find_dialect(example.dialect);
                    cli::Settings settings(std::move(overrides));
                    folders.push_back(
                        read_all({{{{"example.nc", true, true, false},
                                    *settings.for_file("example.nc"),
                                    Source::from_bytes("example.nc", std::string(example.text))}}}));
                }
            }
        }
        return rules;
    }();
    return all;
}

using Programs = std::vector<const Folders*>;

/// The corpus, the examples of the rule, and those of every eighth rule around it: another eighth for its
/// neighbour.
Programs programs_for(const Rule& rule) {
    const auto own = static_cast<std::size_t>(std::ranges::find(all_rules(), &rule) - all_rules().begin());
    Programs programs = {&corpus()};
    for (std::size_t other = own % 8; other < examples().size(); other += 8)
        programs.push_back(&examples()[other]);
    return programs;
}

Programs all_examples() {
    Programs programs;
    for (const Folders& folders : examples()) programs.push_back(&folders);
    return programs;
}

/// What a rule asks for and finds in programs of which the facts are recorded.
struct Asked {
    FactSet facts;
    std::vector<std::string> findings;
};
Asked ask(const Rule& rule, FactSet recorded, const Programs& programs) {
    Asked asked;
    const auto look_at = [&](const std::vector<WorkspaceFile>& folder, bool complete) {
        const auto workspace = analyse(folder, {.complete = complete, .jobs = 1, .facts = recorded});
        const dataflow::AskedFacts watch; // only now: the workspace has asked for its own
        for (const Finding& finding : run_rules(*workspace, {{&rule}}, 1))
            asked.findings.push_back(std::string(finding.source->path()) + " " +
                                     std::to_string(finding.span.begin) + " " + finding.message());
        asked.facts |= watch.types();
    };
    for (const Folders* folders : programs) {
        for (const auto& folder : *folders) {
            look_at(folder, false);
            look_at(folder, true);
        }
    }
    return asked;
}

/// What a search for paths asks for, at loops only: few programs lead a rule there.
constexpr FactSet of_paths = dataflow::facts<dataflow::Store, dataflow::Clobber>();

class FactsOfRules : public testing::TestWithParam<const Rule*> {};

TEST_P(FactsOfRules, AreThoseThatItsRecordDeclares) {
    const Rule& rule = *GetParam();
    const Programs programs = programs_for(rule);
    const Asked with_all = ask(rule, FactSet::all(), programs);
    const FactSet declared = facts_for(rule);
    EXPECT_EQ(with_all.facts - declared, FactSet()) << "asks for " << spell(with_all.facts - declared);
    FactSet in_vain = declared - with_all.facts - of_paths;
    if (in_vain != FactSet()) in_vain = in_vain - ask(rule, FactSet::all(), all_examples()).facts;
    EXPECT_EQ(in_vain, FactSet()) << "declares " << spell(in_vain) << "and never asks for it";
    if (HasFailure()) return; // what is not recorded cannot be asked for
    EXPECT_EQ(ask(rule, declared, programs).findings, with_all.findings);
}

INSTANTIATE_TEST_SUITE_P(All, FactsOfRules, testing::ValuesIn(all_rules().begin(), all_rules().end()),
                         [](const auto& info) { return std::string(info.param->code); });

} // namespace
} // namespace maclint::test
