//! Calls by name: local subprograms, files, and what is handed to them.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "tests/support/analysed.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::program;

constexpr test::FolderOptions closed_workspace{.complete = true, .jobs = 1};

/// The name and file that the only call of a program means; empty: unknown.
std::string called_by(const Workspace& workspace, std::string_view caller) {
    const ProgramAnalysis& analysis = program(workspace, caller);
    if (analysis.calls().size() != 1) throw std::runtime_error("not one call");
    const auto target = analysis.calls().front().target;
    if (!target) return {};
    const ProgramAnalysis& called = workspace.programs()[*target];
    return called.program().name + " in " + called.file().source->path();
}

TEST(DinCalls, ALocalSubprogramIsKnownInItsFileOnly) {
    const std::string sub = "SUBPROGRAM \"BORE\"\nRETURN\nEND\n";
    const auto workspace = test::analyse_files(
        {{"one.nc", "MACHINING\nL\"bore\"\n" + sub}, {"two.nc", "MACHINING\nL\"BORE\"\n"}}, closed_workspace);
    EXPECT_EQ(called_by(*workspace, "one"), "BORE in one.nc");
    EXPECT_EQ(called_by(*workspace, "two"), "");
}

TEST(DinCalls, V1LooksForAFileWhateverItsCase) {
    const auto workspace =
        test::analyse_files({{"one.nc", "MACHINING\nL\"Bore\" V1\nSUBPROGRAM \"BORE\"\nRETURN\nEND\n"},
                             {"BORE.ncs", "MACHINING\nRETURN\n"}},
                            closed_workspace);
    EXPECT_EQ(called_by(*workspace, "one"), "BORE in BORE.ncs");
}

TEST(DinCalls, FoldersPathsAndOtherLanguagesStayUnknown) {
    const auto workspace = test::analyse_files({{"one.nc", "MACHINING\nL\"tools/\" V1\n"},
                                                {"two.nc", "MACHINING\nL\"O9000\" V1\n"},
                                                {"O9000.nc", "O9000\nM99\n"}},
                                               closed_workspace);
    EXPECT_EQ(called_by(*workspace, "one"), "");
    EXPECT_EQ(called_by(*workspace, "two"), "");
}

TEST(DinCalls, ATransferValueThatIsLeftOutIsVacant) {
    const auto workspace =
        test::analyse_files({{"main.nc", "MACHINING\nL\"SUB\" V1 LA1 LB2\nL\"SUB\" V1 LA3\nM30\n"},
                             {"SUB.ncs", "MACHINING\nG0 X#__la Z#__lb Y#__lc\nRETURN\n"}},
                            closed_workspace);
    const auto& reads = program(*workspace, "SUB").facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 3U);
    EXPECT_EQ(reads[0].value.vacancy, dataflow::Vacancy::unknown);
    EXPECT_EQ(reads[1].value.vacancy, dataflow::Vacancy::maybe);
    EXPECT_EQ(reads[2].value.vacancy, dataflow::Vacancy::vacant);
}

TEST(DinCalls, LocalsAreLocal) {
    const auto workspace = test::analyse_text(
        "dinplus",
        "MACHINING\n#l1=5\n#g1=6\nL\"S\"\n#l2=#l1\n#l3=#g1\nM30\nSUBPROGRAM \"S\"\n#l1=7\n#g1=8\nRETURN\n");
    const auto& reads = program(*workspace, "test").facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 2U);
    EXPECT_EQ(reads[0].value.constant(), 5.0);
    EXPECT_EQ(reads[1].value.constant(), 8.0);
}

TEST(DinCalls, WhatIsHandedDownMayBeChanged) {
    const std::string main = "VAR\n#_n=#l1\n#_m=#l2\n#_k=#l90(4)\nMACHINING\n#_n=1\n#_m=2\nL\"S\" V1\n"
                             "G0 X#_n Z#_m Y#l90\nM30\n";
    const auto read_behind_call = [&](std::string sub) {
        const auto workspace =
            test::analyse_files({{"main.nc", main}, {"S.ncs", std::move(sub)}}, closed_workspace);
        std::vector<std::optional<double>> values;
        for (const auto& read : program(*workspace, "main").facts().all<dataflow::Read>())
            values.push_back(read.value.constant());
        return values;
    };
    using EvaluateWords = std::vector<std::optional<double>>;
    EXPECT_EQ(read_behind_call("MACHINING\n#l1=7\nRETURN\n"), (EvaluateWords{1, 2, 4})); // its own #l1
    EXPECT_EQ(read_behind_call("MACHINING\n#_n=7\nRETURN\n"), (EvaluateWords{std::nullopt, 2, 4}));
    EXPECT_EQ(read_behind_call("MACHINING\n#l90=7\nRETURN\n"), (EvaluateWords{1, 2, std::nullopt}));
    EXPECT_EQ(read_behind_call("MACHINING\nL\"UNKNOWN\" V1\nRETURN\n"),
              (EvaluateWords{std::nullopt, std::nullopt, std::nullopt}));
}

TEST(DinCalls, WhatCallersInTheFileLeaveOutMayBeMissing) {
    // A local program can have no other callers, whoever else is on the control.
    const auto workspace =
        test::analyse_text("dinplus", "MACHINING\nL\"S\" LA1\nL\"S\" LA2 LB3\nM30\nSUBPROGRAM \"S\"\n"
                                      "G0 X#__la Z#__lb Y#__lc\nRETURN\n");
    const auto& reads = program(*workspace, "S").facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 3U);
    EXPECT_EQ(reads[0].value.vacancy, dataflow::Vacancy::unknown);
    EXPECT_EQ(reads[1].value.vacancy, dataflow::Vacancy::maybe);
    EXPECT_EQ(reads[2].value.vacancy, dataflow::Vacancy::maybe);
}

TEST(DinCalls, WhatIsHandedDownReachesAllThatIsCalledFromThere) {
    const std::string main = "VAR\n#_n=#l90(5)\n#_m=#l91(5)\nMACHINING\nL\"S\" V1\nM30\n";
    const auto vacancy_in = [&](std::string_view name) {
        const auto workspace =
            test::analyse_files({{"main.nc", main},
                                 {"other.nc", "VAR\n#_k=#l92(5)\nMACHINING\nM30\n"},
                                 {"S.ncs", "MACHINING\nG0 X#l90 Z#l92\nL\"T\" V1\nRETURN\n"},
                                 {"T.ncs", "MACHINING\nG0 X#l91 Z#l92\nL\"S\" V1\nL\"U\" V1\nRETURN\n"},
                                 {"U.ncs", "MACHINING\nG0 X#l90 Z#l92 Y#_n C#_k\nRETURN\n"}},
                                closed_workspace);
        std::vector<dataflow::Vacancy> vacancies;
        for (const auto& read : program(*workspace, name).facts().all<dataflow::Read>())
            vacancies.push_back(read.value.vacancy);
        return vacancies;
    };
    using Vacancies = std::vector<dataflow::Vacancy>;
    // S and T call each other; nothing that hands #l92 down calls them.
    EXPECT_EQ(vacancy_in("S"), (Vacancies{dataflow::Vacancy::unknown, dataflow::Vacancy::vacant}));
    EXPECT_EQ(vacancy_in("T"), (Vacancies{dataflow::Vacancy::unknown, dataflow::Vacancy::vacant}));
    // Names are handed down, too.
    EXPECT_EQ(vacancy_in("U"), (Vacancies{dataflow::Vacancy::unknown, dataflow::Vacancy::vacant,
                                          dataflow::Vacancy::unknown, dataflow::Vacancy::vacant}));
}

TEST(DinCalls, WhatACircleHandsDownReachesAllOfItAndWhatItCalls) {
    const auto workspace =
        test::analyse_files({{"main.nc", "MACHINING\nL\"S\" V1\nL\"V\" V1\nM30\n"},
                             {"S.ncs", "VAR\n#_s=#l93(5)\nMACHINING\nL\"T\" V1\nRETURN\n"},
                             {"T.ncs", "MACHINING\nG0 X#l93 Y#_s\nL\"S\" V1\nL\"U\" V1\nRETURN\n"},
                             {"U.ncs", "MACHINING\nG0 X#l93 Y#_s\nRETURN\n"},
                             {"V.ncs", "MACHINING\nG0 X#l93 Y#_s\nRETURN\n"}},
                            closed_workspace);
    const auto given = [&](std::string_view name) {
        return program(*workspace, name).data().knowledge().handed_down.value().size();
    };
    EXPECT_EQ(given("S"), 0U) << "what it hands down itself does not count";
    EXPECT_EQ(given("T"), 2U);
    EXPECT_EQ(given("U"), 2U);
    EXPECT_EQ(given("V"), 0U) << "only the main program calls it";
}

TEST(DinCalls, OnlyWhatIsStartedByHandRunsOnItsOwn) {
    const auto workspace =
        test::analyse_files({{"main.nc", "MACHINING\nL\"CALLED\" V1\nM30\nSUBPROGRAM \"S\"\nM30\n"},
                             {"CALLED.nc", "MACHINING\nRETURN\n"},
                             {"alone.ncs", "MACHINING\nG0 X1\n"}},
                            closed_workspace);
    EXPECT_TRUE(program(*workspace, "main").is_main());
    EXPECT_FALSE(program(*workspace, "S").is_main());
    EXPECT_FALSE(program(*workspace, "CALLED").is_main());
    EXPECT_FALSE(program(*workspace, "alone").is_main()); // a fragment: nothing says how it is started
}

TEST(DinFlow, BranchesJoinAndARestartLeaves) {
    const auto workspace = test::analyse_text(
        "dinplus",
        "MACHINING\nINPUT(\"n\",#l1)\nIF #l1>3\nTHEN\n#l2=1\nELSE\n#l2=2\nENDIF\n#l3=#l2\nM99\nM30\n");
    const ProgramAnalysis& analysis = program(*workspace, "test");
    const auto& reads = analysis.facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 2U);
    EXPECT_EQ(reads[1].value.low, 1);
    EXPECT_EQ(reads[1].value.high, 2);
    ASSERT_EQ(analysis.facts().all<dataflow::ExitState>().size(), 1U); // M30 is never reached
    EXPECT_EQ(analysis.facts().all<dataflow::ExitState>()[0].exit.kind, flow::ExitKind::restarts);
}

TEST(DinFlow, ContoursRunBeforeTheMachining) {
    const auto workspace =
        test::analyse_text("dinplus", "VAR\n#_d=#l1\nBLANK\n#_d=120\nMACHINING\nG0 X#_d\nM30\n");
    const auto& reads = program(*workspace, "test").facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 1U);
    EXPECT_EQ(reads[0].value.constant(), 120.0);
}

TEST(DinFlow, AValueOfTheControlMayBeMissing) {
    const auto workspace =
        test::analyse_text("dinplus", "MACHINING\n#l1=#a9(X,0)\nIF NDEF(l1)\nTHEN\nENDIF\nM30\n");
    EXPECT_NE(program(*workspace, "test").facts().all<dataflow::Store>()[0].value.vacancy,
              dataflow::Vacancy::set);
}

} // namespace
} // namespace maclint
