//! What rules find in SINUMERIK texts.
#include "analyzer/dialect/dialect.hpp"
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Finding> findings(std::string_view code, std::string text) {
    return run_rules(*test::analyse_text("sinumerik", std::move(text)), {{find_rule(code)}}, 1);
}

TEST(SinumerikWrongBlocks, EachRaisesItsRule) {
    std::ifstream file(MACLINT_SOURCE_DIR "/grammar/sinumerik/test/wrong-blocks.txt");
    ASSERT_TRUE(file);
    std::size_t blocks = 0;
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab == std::string::npos) continue;
        const std::string code = line.substr(tab + 1);
        ASSERT_NE(find_rule(code), nullptr) << line;
        const std::string text = "DEF INT COUNT_, LAST_\nDEF REAL DEPTH, TAB_[5]\nROW_0: G0 X0\n" +
                                 line.substr(0, tab) + "\nROW_1: G0 X1\nROW_2: M30\n";
        EXPECT_FALSE(findings(code, text).empty()) << line;
        ++blocks;
    }
    EXPECT_GT(blocks, 70U);
}

TEST(SinumerikJumps, TakeTheNearestLabelInTheirDirection) {
    EXPECT_THAT(findings("MAC301", "AGAIN: G0 X1\nGOTOF AGAIN\nAGAIN: M30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "AGAIN: G0 X1\nGOTO AGAIN\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "GOTOC NOWHERE\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "DEF STRING[8] WHERE_\nGOTOF WHERE_\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "GOTOF nExt\nNEXT: M30\n"), IsEmpty());
    const auto behind = findings("MAC301", "AGAIN: G0 X1\nN20 GOTOF AGAIN\nM30\n");
    ASSERT_THAT(behind, SizeIs(1));
    EXPECT_THAT(behind.front().message(), HasSubstr("on line 1"));
    EXPECT_THAT(findings("MAC301", "GOTOB N40\nN40 M30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC301", "GOTOF N040\nN40 M30\n"), IsEmpty());
}

TEST(SinumerikPairs, EachConstructHasItsOwnClose) {
    EXPECT_THAT(findings("MAC340", "IF R1==1\nWHILE R2<3\nR2=R2+1\nENDWHILE\nELSE\nENDIF\n"), IsEmpty());
    EXPECT_THAT(findings("MAC340", "IF R1==1 GOTOF NEXT\nNEXT: M30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC340", "REPEAT\nUNTIL R1>5\nPART: G0 X1\nREPEAT PART P=3\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC340", "LOOP\nGOTOF OUT_\nOUT_: M30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC340", "IF R1==(5\nENDIF\n"), IsEmpty()); // it may have opened there
}

TEST(SinumerikCalls, GiveNoMoreThanTheProgramTakes) {
    const std::string called = "%_N_SLOT_SPF\nPROC SLOT(REAL WIDTH, VAR INT STATE_)\nSTATE_=WIDTH\nM17\n";
    const auto main = [&](const std::string& call) {
        return "%_N_A_MPF\nDEF INT DONE\n" + call + "\nM30\n" + called;
    };
    EXPECT_THAT(findings("MAC472", main("SLOT(5,DONE)")), IsEmpty());
    EXPECT_THAT(findings("MAC472", main("SLOT(,DONE)")), IsEmpty());
    EXPECT_THAT(findings("MAC472", main("SLOT(5)")), IsEmpty());
    EXPECT_THAT(findings("MAC472", main("SLOT(5,DONE,1)")), SizeIs(1));
    EXPECT_THAT(findings("MAC472", main("SLOT(5,7)")), SizeIs(1));
}

TEST(SinumerikModes, SaveGivesTheCallersBack) {
    EXPECT_THAT(findings("MAC501", "PROC STEP_UP\nG91 G0 Z10\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC501", "PROC STEP_UP SAVE\nG91 G0 Z10\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("MAC501", "PROC STEP_UP\nG90 G0 Z10\nRET\n"), IsEmpty());
}

TEST(SinumerikRules, ThatWereNotTriedAreNotAsked) {
    EXPECT_FALSE(applies_to(*find_rule("MAC336"), *find_control("sinumerik")));
    EXPECT_TRUE(applies_to(*find_rule("MAC301"), *find_control("sinumerik")));
    EXPECT_TRUE(applies_to(*find_rule("MAC336"), *find_control("fanuc")));
    for (const std::string_view code : find_control("sinumerik")->rules_tried)
        EXPECT_NE(find_rule(code), nullptr) << code;
}

} // namespace
} // namespace maclint
