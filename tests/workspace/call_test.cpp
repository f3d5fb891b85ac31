//! Calls find the nearest program, and depth is counted along the longest chain.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/call_kinds.hpp"
#include "tests/support/analysed.hpp"

#include <gtest/gtest.h>

namespace maclint {
namespace {

constexpr test::FolderOptions open_workspace{.complete = false, .jobs = 2};

const ProgramAnalysis& program(const Workspace& workspace, std::string_view name, std::string_view path) {
    for (const ProgramAnalysis& analysis : workspace.programs())
        if (analysis.program().name == name && analysis.file().source->path() == path) return analysis;
    throw std::runtime_error("no such program");
}

TEST(Calls, TheProgramOfTheSameFolderWins) {
    const auto workspace = test::analyse_files({{"a/main.nc", "O1\nG65P9000\nM30\n"},
                                                {"a/macro.nc", "O9000\nM99\n"},
                                                {"b/macro.nc", "O9000\nM99\n"}},
                                               open_workspace);
    EXPECT_EQ(program(*workspace, "O9000", "a/macro.nc").callers().size(), 1U);
    EXPECT_TRUE(program(*workspace, "O9000", "b/macro.nc").callers().empty());
}

TEST(Calls, TwoProgramsEquallyNearMeanUnknown) {
    const auto workspace = test::analyse_files(
        {{"main.nc", "O1\nG65P9000\nM30\n"}, {"a/macro.nc", "O9000\nM99\n"}, {"b/macro.nc", "O9000\nM99\n"}},
        open_workspace);
    const ProgramAnalysis& main = program(*workspace, "O1", "main.nc");
    ASSERT_EQ(main.calls().size(), 1U);
    EXPECT_FALSE(main.calls().front().target);
    EXPECT_EQ(main.calls().front().candidates, 2U);
}

TEST(Calls, DepthIsCountedAlongTheLongestChain) {
    const auto workspace = test::analyse_fanuc(
        "O1\nG65P2\nG65P4\nM30\nO2\nG65P3\nM99\nO3\nG65P4\nM99\nO4\nM98P5\nM99\nO5\nM99\n");
    EXPECT_EQ(program(*workspace, "O4", "test.nc").depth().macro, 3);
    EXPECT_EQ(program(*workspace, "O5", "test.nc").depth().subprogram, 1);
    EXPECT_EQ(program(*workspace, "O4", "test.nc").chain_to(NestingLimit::macro).size(), 3U);
}

TEST(Calls, ProgramsThatCallEachOtherAreRecursive) {
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM30\nO2\nM98P3\nM99\nO3\nM98P2\nM99\n");
    EXPECT_FALSE(program(*workspace, "O1", "test.nc").is_recursive());
    EXPECT_TRUE(program(*workspace, "O2", "test.nc").is_recursive());
    EXPECT_TRUE(program(*workspace, "O3", "test.nc").is_recursive());
}

TEST(Calls, ACompleteWorkspaceTellsWhichArgumentsAreMissing) {
    const std::string main = "O1\nG65P9000A1.B2.\nG65P9000A3.\nM30\n";
    const auto workspace = test::analyse_files({{"main.nc", main}, {"macro.nc", "O9000\nG0X#1Y#2Z#3\nM99\n"}},
                                               {.complete = true, .jobs = 1});
    const ProgramAnalysis& macro = program(*workspace, "O9000", "macro.nc");
    ASSERT_EQ(macro.facts().all<dataflow::Read>().size(), 3U);
    EXPECT_EQ(macro.facts().all<dataflow::Read>()[0].value.vacancy, dataflow::Vacancy::unknown);
    EXPECT_EQ(macro.facts().all<dataflow::Read>()[1].value.vacancy, dataflow::Vacancy::maybe);
    EXPECT_EQ(macro.facts().all<dataflow::Read>()[2].value.vacancy, dataflow::Vacancy::vacant);
}

/// What is known of the only variable that the macro reads, in a complete workspace.
dataflow::Vacancy read_in_macro(const std::vector<test::NamedText>& files, std::string_view macro) {
    const auto workspace = test::analyse_files(files, {.complete = true, .jobs = 1});
    return program(*workspace, "O9000", macro).facts().all<dataflow::Read>().front().value.vacancy;
}

TEST(Calls, ACallThatMayMeanTheProgramMayPassWhatOthersLeaveOut) {
    const test::NamedText caller{"main.nc", "O1\nG65P9000\nM30\n"};
    const test::NamedText macro{"macro.nc", "O9000\nG0X#24\nM99\n"};
    EXPECT_EQ(read_in_macro({caller, macro}, "macro.nc"), dataflow::Vacancy::vacant);
    EXPECT_EQ(read_in_macro({caller, macro, {"any.nc", "O2\nG65P#100X5.\nM30\n"}}, "macro.nc"),
              dataflow::Vacancy::maybe);
    EXPECT_EQ(read_in_macro({{"a/main.nc", caller.second},
                             {"a/macro.nc", macro.second},
                             {"b/macro.nc", macro.second},
                             {"c/main.nc", "O2\nG65P9000X5.\nM30\n"}},
                            "a/macro.nc"),
              dataflow::Vacancy::maybe);
}

TEST(Calls, ALetterThatOnlyACallerWithAChoicePassesMayBeThere) {
    // #10 is no letter's variable; only this call passes it, as the third I of a list.
    const std::string macro = "O9000\nG0X#10\nM99\n";
    const auto vacancy = [&](const std::string& call) {
        const auto workspace = test::analyse_files(
            {{"a/macro.nc", macro}, {"b/macro.nc", macro}, {"main.nc", "O1\n" + call + "\nM30\n"}},
            open_workspace);
        const ProgramAnalysis& analysis = program(*workspace, "O9000", "b/macro.nc");
        EXPECT_EQ(analysis.possible_callers().first.size(), 1U);
        return analysis.facts().all<dataflow::Read>().front().value.vacancy;
    };
    EXPECT_EQ(vacancy("G65P9000A1."), dataflow::Vacancy::vacant);
    EXPECT_EQ(vacancy("G65P9000I1.I2.I3."), dataflow::Vacancy::maybe);
    EXPECT_EQ(vacancy("M98P9000"), dataflow::Vacancy::unknown);
}

TEST(Calls, WhatIsAddedToANumberFillsItsZeros) {
    const auto may_be_called = [](const std::string& number, const std::string& called) {
        const auto workspace =
            test::analyse_fanuc("O1\nM98P[" + number + "]\nM30\nO" + called + "\nG0X1.\nM99\n");
        return program(*workspace, "O" + called, "test.nc").has_possible_callers();
    };
    for (const char* within : {"7100", "7101", "7199"})
        EXPECT_TRUE(may_be_called("7100+#501", within)) << within;
    for (const char* beyond : {"7099", "7200"}) EXPECT_FALSE(may_be_called("7100+#501", beyond)) << beyond;
    EXPECT_TRUE(may_be_called("#501+2000", "2999"));
    EXPECT_FALSE(may_be_called("#501+2000", "3000"));
    EXPECT_TRUE(may_be_called("7101+#501", "9000")) << "there is no zero that tells";
    EXPECT_TRUE(may_be_called("7101-#501", "7000")) << "no sum";
    EXPECT_TRUE(may_be_called("0+#501", "5"));
}

TEST(Calls, ALetterThatIsGivenTwiceIsPassedByOneCaller) {
    EXPECT_EQ(read_in_macro(
                  {{"main.nc", "O1\nG65P9000X1.X2.\nG65P9000\nM30\n"}, {"macro.nc", "O9000\nG0X#24\nM99\n"}},
                  "macro.nc"),
              dataflow::Vacancy::maybe);
}

TEST(Calls, ANamedVariableIsTheSameInCallerAndCalled) {
    const std::string main = "O1\n[#_DEPTH]=1\nM98P2\n#1=#_DEPTH\nM30\n";
    const auto read_after = [&](const std::string& called) {
        const auto workspace = test::analyse_fanuc(main + called);
        return program(*workspace, "O1", "test.nc").facts().all<dataflow::Read>().back().value.constant();
    };
    EXPECT_EQ(read_after("O2\n[#_OTHER]=9\nM99\n"), 1.0);
    EXPECT_EQ(read_after("O2\n[#_OTHER]=8\n[#_DEPTH]=9\nM99\n"), 9.0);
}

TEST(Calls, TheNearestFolderIsFoundWhateverItsDepth) {
    const std::string macro = "O9000\nM99\n";
    const auto called_from = [&](const std::string& path) -> std::string {
        const auto workspace = test::analyse_files({{"a/b/c/macro.nc", macro},
                                                    {"a/macro.nc", macro},
                                                    {"d/e/macro.nc", macro},
                                                    {path, "O1\nG65P9000\nM30\n"}},
                                                   open_workspace);
        const ProgramAnalysis& main = program(*workspace, "O1", path);
        EXPECT_EQ(main.calls().front().candidates, 3U);
        const auto target = main.calls().front().target;
        return target ? workspace->programs()[*target].file().source->path() : "";
    };
    EXPECT_EQ(called_from("a/b/c/d/main.nc"), "a/b/c/macro.nc");
    EXPECT_EQ(called_from("a/b/main.nc"), "");   // one step up or one step down
    EXPECT_EQ(called_from("a/b/x/main.nc"), ""); // up and down, or up twice
    EXPECT_EQ(called_from("a/x/main.nc"), "a/macro.nc");
    EXPECT_EQ(called_from("main.nc"), "a/macro.nc");
    EXPECT_EQ(called_from("d/main.nc"), "d/e/macro.nc");
}

} // namespace
} // namespace maclint
