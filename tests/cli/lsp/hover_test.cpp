//! What words mean, in all languages, and what comes of places where nothing is.
#include "tests/cli/lsp/scripted_session.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class LspHover : public testing::Test {
  protected:
    void open(const std::string& text, const std::string& language) {
        session.begin(Json::object());
        session.open("O1.nc", text, language);
    }
    Json hover(int line, int character) {
        return session.result("textDocument/hover", {{"textDocument", {{"uri", session.uri("O1.nc")}}},
                                                     {"position", place(line, character)}});
    }
    /// The text; empty where there is none.
    std::string words(int line, int character) {
        const Json answer = hover(line, character);
        return answer.is_null() ? "" : answer["contents"]["value"].get<std::string>();
    }

    ScriptedSession session;
};

TEST_F(LspHover, TellsWhatVariablesAreAndWhereTheyAreSet) {
    open("%\nO1\n#100=5.(WIDTH)\nIF[#100EQ1]THEN #501=#4109\n#100=#100+#5041\nG65P9100F#9\nM30\n%\n",
         "fanuc");
    EXPECT_THAT(words(3, 4),
                AllOf(HasSubstr("**#100**"), HasSubstr("all programs share it"),
                      HasSubstr("line 3: `#100=5.(WIDTH)`"), HasSubstr("line 5: `#100=#100+#5041`")));
    EXPECT_EQ(shown(hover(3, 4)["range"]), "3:3-3:7");
    EXPECT_THAT(words(3, 23), AllOf(HasSubstr("**#4109**"), HasSubstr("feed")));
    EXPECT_THAT(words(4, 12), AllOf(HasSubstr("**#5041**"), HasSubstr("can only be read")));
    EXPECT_THAT(words(5, 9), AllOf(HasSubstr("**#9**"), HasSubstr("argument F of a macro call")));
    EXPECT_THAT(words(5, 8), HasSubstr("**F** argument: #9 of the called program"));
}

TEST_F(LspHover, TellsTheValueThatIsKnown) {
    open("%\nO1\n#3=5.\nIF[#7EQ1]THEN#3=6.\n#2=#0\nG0X#3Y#2\nG65P9999\nG0X#100Y#4\nM99\n%\n", "fanuc");
    EXPECT_THAT(words(5, 4), HasSubstr("Here: 5 or 6\n"));
    EXPECT_THAT(words(5, 7), HasSubstr("Here: vacant"));
    EXPECT_THAT(words(2, 1), HasSubstr("Stored here: 5\n"));
    EXPECT_THAT(words(7, 5), Not(HasSubstr("Here")));
    EXPECT_THAT(words(7, 9), Not(HasSubstr("Here")));
}

TEST_F(LspHover, TellsWhatCallersPass) {
    open("%\nO1\nG65P9100F100.X#5\nG65P9100F250.\nG65P9100F100.\nM30\nO9100\nG1X#24F#9\n#2=#4\nM99\n%\n",
         "fanuc");
    EXPECT_THAT(words(7, 8),
                AllOf(HasSubstr("Callers pass `100.`, `250.`"), Not(HasSubstr("`250.`, `100.`"))));
    EXPECT_THAT(words(7, 4), HasSubstr("Callers pass `#5`"));
    EXPECT_THAT(words(8, 4), Not(HasSubstr("Callers pass")));
}

TEST_F(LspHover, TellsWhatCodesAndTheirWordsMean) {
    open("%\nO1\nG90G54\nG83X1.Z-5.R1.Q#1F100\nG83X1.Z-5.R1.Q1.F100\nM30\n%\n", "fanuc");
    for (const int line : {3, 4}) {
        EXPECT_THAT(words(line, 1), AllOf(StartsWith("**G83** peck drilling"), HasSubstr("cancelled by G80"),
                                          HasSubstr("`Q` depth of a peck")));
        EXPECT_THAT(words(line, 10), HasSubstr("**R** of G83: level where the feed begins"));
    }
    EXPECT_THAT(words(2, 1), HasSubstr("until G91"));
    EXPECT_EQ(shown(hover(4, 1)["range"]), "4:0-4:3");
    EXPECT_THAT(words(5, 0), HasSubstr("**M30**"));
}

TEST_F(LspHover, KnowsTheWordsOfEachLanguage) {
    open("%\nO1\nWHILE[#1LT5]DO1\n#1=SIN[#1]\nEND1\nM30\n%\n", "fanuc");
    EXPECT_THAT(words(2, 2), HasSubstr("**WHILE** keyword"));
    EXPECT_THAT(words(2, 9), HasSubstr("**LT** comparison or logic: less"));
    EXPECT_THAT(words(3, 4), HasSubstr("**SIN** function: sine"));
}

TEST_F(LspHover, KnowsTheWordsOfSinumerik) {
    open("DEF REAL _WIDTH=5\nR1=_WIDTH\nG41 DIAMON\nCYCLE83(R1,2,3)\nIF R1>5 GOTOF "
         "ENDE\nENDE:\nR2=$P_EP[X]\nM30\n",
         "sinumerik");
    EXPECT_THAT(words(0, 1), HasSubstr("**DEF** keyword: declares"));
    EXPECT_THAT(words(1, 5), AllOf(HasSubstr("_WIDTH"), HasSubstr("declared as REAL")));
    EXPECT_THAT(words(1, 0), AllOf(HasSubstr("**R1**"), HasSubstr("line 2: `R1=_WIDTH`")));
    EXPECT_THAT(words(2, 1), HasSubstr("radius compensation"));
    EXPECT_THAT(words(2, 6), HasSubstr("**DIAMON**"));
    EXPECT_THAT(words(3, 3), HasSubstr("**CYCLE83** cycle: deep holes"));
    EXPECT_THAT(words(4, 9), HasSubstr("**GOTOF** keyword: jump forward"));
    EXPECT_THAT(words(6, 5), HasSubstr("**$P_EP** REAL, with 1 index; the last position of the program"));
}

TEST_F(LspHover, TakesNoTextForARemark) {
    open("MSG(\"row; \"<<R1)\nR1=5 ; R1 \"row\" R1\nM30\n", "sinumerik");
    EXPECT_THAT(words(0, 13), HasSubstr("**R1**"));
    EXPECT_THAT(words(1, 0), HasSubstr("**R1**"));
    EXPECT_THAT(words(1, 7), Not(HasSubstr("**R1**")));
    EXPECT_THAT(words(1, 16), Not(HasSubstr("**R1**")));
}

TEST_F(LspHover, KnowsTheWordsOfDinPlus) {
    open("MACHINING\nN1 #l1=SQRT(5)\nN2 G860 NS1 NE2 I0.5\nN3 M8\nN4 M30\nEND\n", "dinplus");
    EXPECT_THAT(words(1, 8), HasSubstr("**SQRT** function: square root"));
    EXPECT_THAT(words(1, 4), AllOf(HasSubstr("#l1"), HasSubstr("line 2: ")));
    EXPECT_THAT(words(2, 4), StartsWith("**G860** contour recessing"));
    EXPECT_THAT(words(2, 8), HasSubstr("**NS** of G860: first block of the contour"));
    EXPECT_THAT(words(3, 4), HasSubstr("**M8** coolant circuit 1 on"));
}

TEST_F(LspHover, ShowsTheWordsOfTheShopFirst) {
    session.folder.write(".maclint.json",
                         R"({"words": {"M08": "coolant of the gun drill", "#0550": "offset of the probe"}})");
    open("%\nO1\nM8\nG0X#550\nM08G1\nM80\nM30\n%\n", "fanuc");
    EXPECT_THAT(words(2, 1), StartsWith("**M8** coolant of the gun drill\n\n**M8** coolant on"));
    EXPECT_THAT(words(4, 1), StartsWith("**M08** coolant of the gun drill"));
    EXPECT_THAT(words(3, 6), StartsWith("**#550** offset of the probe\n\n**#550**"));
    EXPECT_THAT(words(5, 1), Not(HasSubstr("gun")));
}

TEST_F(LspHover, ShowsRulesThatCommentsAllowAndAlarms) {
    session.folder.write(".maclint.json", R"({"files": [{"glob": "**", "control": "fanuc-30i"}]})");
    open("%\nO1\nG0X1.(MACLINT ALLOW MAC301)\n(ALARM 128)\n(PIECE 128)\nM30\n%\n", "fanuc");
    EXPECT_THAT(words(2, 22), StartsWith("**MAC301** jump-target-missing"));
    EXPECT_THAT(words(3, 8), HasSubstr("**Alarm 128**"));
    EXPECT_EQ(words(4, 8), "");
    EXPECT_EQ(words(2, 8), "");
}

TEST_F(LspHover, HasNothingToSayWhereNothingStands) {
    open("%\nO1\nG0X1.\n\nM30\n%\n", "fanuc");
    EXPECT_EQ(words(3, 0), "");
    EXPECT_EQ(words(100, 5), "");
    EXPECT_EQ(words(2, 1000000), "");
    const Json answer = session.ask("textDocument/hover", {{"textDocument", {{"uri", session.uri("O1.nc")}}},
                                                           {"position", place(-1, 0)}});
    EXPECT_EQ(answer["error"]["code"], -32602);
    session.open("O2.nc", "", "fanuc");
    const Json empty = session.result(
        "textDocument/hover", {{"textDocument", {{"uri", session.uri("O2.nc")}}}, {"position", place(0, 0)}});
    EXPECT_TRUE(empty.is_null());
}

} // namespace
} // namespace maclint::test
