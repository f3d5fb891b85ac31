//! How far rules look: what lies beyond is not found, and said to be so where it could be.
#include "rules/bounds_met.hpp"
#include "rules/rule.hpp"
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/lines.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::copies_of;
using test::lines_raised;
using test::messages_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

struct BoundedRun {
    std::vector<Finding> findings;
    std::vector<BoundMet> bounds;
};

BoundedRun run_over(std::string_view code, const std::vector<test::NamedText>& files) {
    const auto workspace = test::analyse_files(files, {.complete = false, .jobs = 1});
    BoundedRun met;
    met.findings = run_rules(*workspace, {{find_rule(code)}}, 1, met.bounds, {});
    return met;
}

/// Two programs of one number, and so many programs that call it, with this block behind the call.
std::vector<test::NamedText> namesakes(const std::string& text, int callers, const std::string& behind) {
    std::vector<test::NamedText> files{{"a/x.nc", text}, {"b/x.nc", text}};
    for (int i = 0; i < callers; ++i) {
        const std::string number = std::to_string(1000 + i);
        std::string caller = "O" + number;
        caller += "\nM98P100\n" + behind + "\nM30\n";
        files.emplace_back(number + ".nc", std::move(caller));
    }
    return files;
}

TEST(Bounds, OfCallsThatMayMeanAProgramTheFirstHundredAreAsked) {
    const std::string leaves_g91 = "O100\nG91G1X1.F100\nM99\n";
    EXPECT_THAT(run_over("MAC501", namesakes(leaves_g91, 101, "X5.")).findings, SizeIs(2));
    // Whoever is asked gives G90 again; the last one is not asked.
    EXPECT_THAT(run_over("MAC501", namesakes(leaves_g91, 100, "G90")).bounds, IsEmpty());
    EXPECT_THAT(run_over("MAC501", namesakes(leaves_g91, 101, "G90")).bounds, SizeIs(2));
    EXPECT_THAT(run_over("MAC501", namesakes(leaves_g91, 101, "G90")).findings, IsEmpty());

    // It reads what the run before has left, unless a caller sets it: the last one may.
    const std::string stale =
        "O100\nIF[#4012EQ54]GOTO1\nIF[#4012EQ55]GOTO1\nIF[#4012EQ56]GOTO1\n#3000=1\nN1\n"
        "IF[#4012EQ54]THEN#103=3\nIF[#4012EQ56]THEN#103=2\nG0X#103\nM99\n";
    EXPECT_THAT(run_over("MAC216", namesakes(stale, 100, "G90")).findings, SizeIs(2));
    EXPECT_THAT(run_over("MAC216", namesakes(stale, 101, "G90")).findings, IsEmpty());
    EXPECT_THAT(run_over("MAC216", namesakes(stale, 101, "G90")).bounds, SizeIs(2));
}

TEST(Bounds, AMoveStandsAtMost2000BlocksBeforeAPosition) {
    const auto offset_after = [](std::size_t blocks) {
        return lines_raised("MAC605",
                            "O9001\nG1X5.F100.\n" + copies_of("#1=1\n", blocks) + "#5221=#5021\nM99\n");
    };
    EXPECT_THAT(offset_after(1990), SizeIs(1));
    EXPECT_THAT(offset_after(2010), IsEmpty());
}

TEST(Bounds, AUseStandsAtMost2000BlocksBehindATestForZero) {
    const auto use_after = [](std::size_t blocks) {
        return run_over("MAC220", {{"x.nc", "O9001\nIF[#1EQ0]GOTO9\n" + copies_of("#2=1\n", blocks) +
                                                "#3=5/#1\nN9M99\n"}});
    };
    EXPECT_THAT(use_after(1900).findings, SizeIs(1));
    EXPECT_THAT(use_after(1900).bounds, IsEmpty());
    EXPECT_THAT(use_after(2100).findings, IsEmpty());
    EXPECT_THAT(use_after(2100).bounds, SizeIs(1));
}

TEST(Bounds, ATestIsLookedForAmong1000BeforeTheOneThatItDecides) {
    const auto decided = [](std::size_t tests) {
        return messages_raised("MAC718", "O9001\nIF[#1GT5]GOTO9\n" + copies_of("IF[#2GT5]THEN#3=1\n", tests) +
                                             "IF[#1GT10]THEN#4=1\nN9M99\n");
    };
    EXPECT_THAT(decided(999), ElementsAre(HasSubstr("[#1GT5]")));
    EXPECT_THAT(decided(1000), ElementsAre(Not(HasSubstr("[#1GT5]"))));
}

TEST(Bounds, OfOperandsThatMayBeZero500AreHeldAgainstTheChecks) {
    const auto divisions = [](int count) {
        std::string text = "O9001\n";
        for (int i = 1; i <= count; ++i) text += "#2=1/[#1*" + std::to_string(i) + "]\n";
        return run_over("MAC702", {{"x.nc", text + "M99\n"}});
    };
    EXPECT_THAT(divisions(500).bounds, IsEmpty());
    EXPECT_THAT(divisions(501).bounds, SizeIs(1));
    EXPECT_EQ(divisions(501).findings.size(), divisions(500).findings.size());
}

TEST(Bounds, BehindAllStoresAMillionNodesAreLookedAtAndAThousandForEach) {
    constexpr std::size_t stores = 32;
    const auto stored_before = [](std::size_t tests) {
        std::string text = "O1\n";
        for (std::size_t i = 1; i <= stores; ++i) text += "#" + std::to_string(i) + "=#100+1\n";
        return run_over("MAC213", {{"x.nc", text + copies_of("IF[#100EQ1]GOTO9\n", tests) + "N9M30\n"}});
    };
    EXPECT_THAT(stored_before(16'100).findings, SizeIs(stores));
    EXPECT_THAT(stored_before(16'100).bounds, IsEmpty());
    EXPECT_THAT(stored_before(16'150).findings, SizeIs(stores - 1));
    EXPECT_THAT(stored_before(16'150).bounds, SizeIs(1));
}

TEST(Bounds, OfTheAssignmentsThatReplaceAValueEightAreNamed) {
    const auto replaced_by = [](int assignments) {
        std::string text = "O9001\n#1=#100+1\n";
        for (int i = 1; i < assignments; ++i) {
            const std::string label = std::to_string(i);
            text.append("IF[#100EQ").append(label).append("]GOTO").append(label).append("\n");
        }
        text += "#1=#101+1\nG0X#1\nM99\n";
        for (int i = 1; i < assignments; ++i)
            text += "N" + std::to_string(i) + "#1=#102+" + std::to_string(i) + "\nG0X#1\nM99\n";
        return run_over("MAC213", {{"x.nc", text}}).findings.at(0).related.size();
    };
    EXPECT_EQ(replaced_by(7), 7U);
    EXPECT_EQ(replaced_by(9), 8U);
}

TEST(Bounds, WhatARuleLooksAtInOneProgram) {
    // Each case is held against all before it.
    const auto cases = [](std::size_t count) {
        std::string text = "O1\nIF[#500EQ0]THEN#101=1\nIF[#500EQ0]THEN#101=2\nIF[#500EQ0]THEN#101=4\n";
        for (std::size_t i = 1; i <= count; ++i) {
            const std::string number = std::to_string(i);
            text.append("IF[#500EQ").append(number).append("]THEN#101=3\n");
        }
        return run_over("MAC719", {{"x.nc", text + "IF[#500EQ0]THEN#101=5\nG1X#101F1.\nM30\n"}});
    };
    EXPECT_THAT(cases(1500).findings, SizeIs(3));
    EXPECT_THAT(cases(1500).bounds, IsEmpty());
    // The one that is being told when the limit is met is left out, too.
    EXPECT_THAT(cases(4000).findings, IsEmpty());
    EXPECT_THAT(cases(4000).bounds, SizeIs(1));
}

TEST(Bounds, BlocksTimesVariablesOfAProgramWhoseValuesAreLost) {
    const auto variables = [](std::size_t count) {
        std::string text = "MACHINING\nN1 #l1=#g1+1\nN2 #l1=#g1+2\n";
        for (std::size_t i = 1; i <= count; ++i) text += "#g" + std::to_string(i) + "=1\n";
        return run_over("MAC213", {{"x.ncs", text + "N3 G0 X#l1\nM30\nEND\n"}});
    };
    EXPECT_THAT(variables(10'000).findings, SizeIs(1));
    EXPECT_THAT(variables(10'000).bounds, IsEmpty());
    EXPECT_THAT(variables(30'000).findings, IsEmpty());
    EXPECT_THAT(variables(30'000).bounds, SizeIs(1));
}

// ---- what took a power of its depth, and would not end

TEST(Bounds, ConditionsInBracketsTakeNoPowerOfTheirDepth) {
    std::string condition = "[#500EQ1]";
    for (int i = 1; i < 40; ++i) {
        condition.insert(0, "[").append(i % 2 == 0 ? "AND" : "OR");
        condition.append("[#").append(std::to_string(500 + i)).append("EQ1]]");
    }
    EXPECT_THAT(lines_raised("MAC301", "O1\nIF" + condition + "GOTO10\nN10M30\n"), IsEmpty());
}

/// `#101=#100+#100+…`, `#102=#101+#101+…` and so on up to `last`.
std::string sums_of_sums(int last) {
    std::string text;
    for (int variable = 101; variable <= last; ++variable) {
        const std::string summand = "#" + std::to_string(variable - 1);
        text += "#" + std::to_string(variable) + "=" + summand;
        for (int i = 0; i < 60; ++i) text += "+" + summand;
        text += "\n";
    }
    return text;
}

TEST(Bounds, SumsOfSumsTakeNoPowerOfTheirDepth) {
    EXPECT_THAT(
        messages_raised("MAC718", "O1\n#100=1\n" + sums_of_sums(107) + "IF[#107GT5]GOTO9\nG0X1\nN9M30\n"),
        IsEmpty());
    // What decides over the alarm of a program that is called in a loop.
    EXPECT_THAT(lines_raised("MAC319", "O1\nWHILE[#500LT5]DO1\n" + sums_of_sums(108) +
                                           "M98P2\nEND1\nM30\nO2\nIF[#108LT-5]THEN#3000=1(NO)\nM99\n"),
                ElementsAre(2));
}

TEST(Bounds, AValueMayComeFromAHundredThousandAssignments) {
    EXPECT_THAT(
        lines_raised("MAC702", "O1\n#4=0\n" + copies_of("#5=#4*1\n#4=#5*1\n", 64'000) + "#6=1/#4\nM30\n"),
        SizeIs(1));
}

} // namespace
} // namespace maclint
