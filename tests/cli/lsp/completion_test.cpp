//! What may follow what is typed, with its meaning; letters beside arguments; kinds of names.
#include "tests/cli/lsp/scripted_session.hpp"

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Key;
using testing::Not;
using testing::Pair;

class LspTyping : public testing::Test {
  protected:
    void open(const std::string& text, const std::string& language) {
        session.begin(Json::object());
        session.open("O1.nc", text, language);
    }
    Json at(int line, int character) const {
        return {{"textDocument", {{"uri", session.uri("O1.nc")}}}, {"position", place(line, character)}};
    }
    /// What is offered, with what stands beside it.
    std::map<std::string, std::string> offered(int line, int character) {
        std::map<std::string, std::string> all;
        const Json answer = session.result("textDocument/completion", at(line, character));
        if (!answer.is_object()) return all;
        for (const Json& item : answer["items"]) all[item["label"]] = item.value("detail", "");
        return all;
    }
    Json range(int first, int last) const {
        return {{"textDocument", {{"uri", session.uri("O1.nc")}}},
                {"range", {{"start", place(first, 0)}, {"end", place(last, 0)}}}};
    }

    ScriptedSession session;
};

TEST_F(LspTyping, OffersCodesAndTheWordsThatTheyTake) {
    open("%\nO1\nG8\nG83X1.Q\nWHI\nM30\n%\n", "fanuc");
    EXPECT_THAT(offered(2, 2), Contains(Pair("G83", "peck drilling")));
    EXPECT_THAT(offered(2, 2), Not(Contains(Key("G54"))));
    EXPECT_THAT(offered(3, 7), Contains(Pair("Q", "depth of a peck")));
    EXPECT_THAT(offered(4, 3), Contains(Pair("WHILE", HasSubstr("repeated while"))));
    const Json answer = session.result("textDocument/completion", at(2, 2));
    EXPECT_EQ(shown(answer["items"][0]["textEdit"]["range"]), "2:0-2:2");
}

TEST_F(LspTyping, OffersProgramsBehindCallsAndBlocksBehindJumps) {
    session.folder.write("O9100.nc", "%\nO9100\nM99\n%\n");
    session.folder.write("A.MPF", "M30\n");
    open("%\nO1\nG65P91\nGOTO\nN50G0X1.\nM98 P\nM30\n%\n", "fanuc");
    EXPECT_THAT(offered(2, 6), ElementsAre(Pair("9100", "O9100.nc")));
    EXPECT_THAT(offered(3, 4), ElementsAre(Pair("50", "N50G0X1.")));
    EXPECT_THAT(offered(5, 5), ElementsAre(Pair("1", "O1.nc"), Pair("9100", "O9100.nc")));
}

TEST_F(LspTyping, OffersLabelsAndDeclaredVariables) {
    open("DEF REAL _LEN=5\nSTART:\nG1 X=_LEN\nGOTOB \nM30\n", "sinumerik");
    EXPECT_THAT(offered(3, 6), ElementsAre(Pair("START", "")));
    EXPECT_THAT(offered(2, 7), Contains(Pair("_LEN", "REAL")));
}

TEST_F(LspTyping, OffersVariablesWithTheWordsOfTheShop) {
    session.folder.write(".maclint.json", R"({"words": {"#550": "offset of the probe"}})");
    open("%\nO1\n#100=1\nG0X#\nM30\n%\n", "fanuc");
    const auto all = offered(3, 4);
    EXPECT_THAT(all, Contains(Pair("#100", HasSubstr("variable"))));
    EXPECT_THAT(all, Contains(Pair("#550", "offset of the probe")));
    EXPECT_THAT(all, Contains(Key("#3000")));
    EXPECT_THAT(all, Not(Contains(Key("G83"))));
}

TEST_F(LspTyping, TellsTheMeaningOfAnItemThatIsChosen) {
    open("%\nO1\nG83\n(G8)\nM30\n%\n", "fanuc");
    const Json answer = session.result("textDocument/completion", at(2, 3));
    ASSERT_FALSE(answer["items"].empty());
    const Json item = session.result("completionItem/resolve", answer["items"][0]);
    EXPECT_THAT(item["documentation"]["value"].get<std::string>(), HasSubstr("peck drilling"));
    EXPECT_THAT(session.result("textDocument/completion", at(3, 3)), IsEmpty());
    EXPECT_EQ(session.ask("completionItem/resolve", {{"label", "G1"}})["error"]["code"], -32602);
}

TEST_F(LspTyping, IsShownTheLettersOfArguments) {
    open("%\nO9100\nG1X#24F[#9]\n#1=5\nG1X#1\nM99\n%\n", "fanuc");
    std::vector<std::string> hints;
    for (const Json& hint : session.result("textDocument/inlayHint", range(0, 7)))
        hints.push_back(hint["label"].get<std::string>() + " " +
                        std::to_string(hint["position"]["line"].get<int>()) + ":" +
                        std::to_string(hint["position"]["character"].get<int>()));
    EXPECT_THAT(hints, ElementsAre("X 2:6", "F 2:10"));
    EXPECT_THAT(session.result("textDocument/inlayHint", range(4, 7)), IsEmpty());
}

TEST_F(LspTyping, IsShownWhereAComputedJumpLeads) {
    open("%\nO1\n#1=10\nIF[#100EQ1]THEN#1=20\nGOTO#1\nN10G0X1.\nN20GOTO#500\nM30\n%\n", "fanuc");
    const Json hints = session.result("textDocument/inlayHint", range(0, 8));
    ASSERT_EQ(hints.size(), 1U);
    EXPECT_EQ(hints[0]["label"], "N10 N20");
    EXPECT_EQ(hints[0]["position"], place(4, 6));
}

TEST_F(LspTyping, SeesNoLettersInAMainProgram) {
    open("%\nO1\nG1X#24\nM30\n%\n", "fanuc");
    EXPECT_THAT(session.result("textDocument/inlayHint", range(0, 5)), IsEmpty());
}

TEST_F(LspTyping, HasItsNamesTold) {
    open("%\nO1\n#100=#4109\nG65P9100A#100\nM30\n%\n", "fanuc");
    const Json data = session.result("textDocument/semanticTokens/full", at(0, 0))["data"];
    // O1, #100 stored, #4109 of the control, 9100, A, #100: line, column, length, type, modifiers
    EXPECT_EQ(data, Json({1, 0, 2, 2, 1, 1, 0, 4, 0, 2, 0, 5, 5, 0, 4,
                          1, 4, 4, 2, 0, 0, 4, 1, 4, 0, 0, 1, 4, 0, 0}));
    const Json part = session.result("textDocument/semanticTokens/range", range(3, 4))["data"];
    EXPECT_EQ(part, Json({3, 4, 4, 2, 0, 0, 4, 1, 4, 0, 0, 1, 4, 0, 0}));
}

} // namespace
} // namespace maclint::test
