//! Programs, variables, tools and names of blocks: where they are, who names them, who calls whom.
#include "tests/cli/lsp/scripted_session.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class LspNames : public testing::Test {
  protected:
    void open(const std::string& name, const std::string& text, const std::string& language) {
        session.begin(Json::object());
        name_ = name;
        session.open(name, text, language);
    }
    Json at(int line, int character) const {
        return {{"textDocument", {{"uri", session.uri(name_)}}}, {"position", place(line, character)}};
    }
    /// "O2.nc 1:0-1:2", a place each.
    static std::vector<std::string> places(const Json& list) {
        std::vector<std::string> all;
        for (const Json& each : list) {
            const auto uri = each["uri"].get<std::string>();
            all.push_back(uri.substr(uri.rfind('/') + 1) + " " + shown(each["range"]));
        }
        return all;
    }
    std::vector<std::string> definition(int line, int character) {
        return places(session.result("textDocument/definition", at(line, character)));
    }
    std::vector<std::string> references(int line, int character, bool with_declaration) {
        Json params = at(line, character);
        params["context"] = {{"includeDeclaration", with_declaration}};
        return places(session.result("textDocument/references", params));
    }
    Json renamed(int line, int character, const std::string& name) {
        Json params = at(line, character);
        params["newName"] = name;
        return session.ask("textDocument/rename", params);
    }
    std::string refusal(int line, int character, const std::string& name) {
        return renamed(line, character, name)["error"]["message"].get<std::string>();
    }
    std::vector<std::string> edits(const Json& answer) {
        std::vector<std::string> all;
        for (const Json& each : answer["result"]["changes"][session.uri(name_)])
            all.push_back(shown(each["range"]) + " " + each["newText"].get<std::string>());
        return all;
    }

    ScriptedSession session;
    std::string name_;
};

constexpr const char* caller =
    "%\nO1(MAIN)\n#100=5.\nG65P9100A1.F#100\nM98P9100\nT0101\nG65P9200\nT12\nT101\nM30\n%\n";
constexpr const char* macro = "%\nO9100(HOLE)\nG1X[#1+#100]F#9\n#100=#1\nM99\n%\n";

TEST_F(LspNames, LeadFromACallToTheProgramThatTheAnalysisTakes) {
    session.folder.write("O9100.nc", macro);
    session.folder.write("other/O9100.nc", macro);
    open("O1.nc", caller, "fanuc");
    EXPECT_THAT(definition(3, 4), ElementsAre("O9100.nc 1:0-1:5"));
    EXPECT_THAT(definition(3, 3), ElementsAre("O9100.nc 1:0-1:5"));
    EXPECT_THAT(definition(4, 6), ElementsAre("O9100.nc 1:0-1:5"));
    EXPECT_THAT(definition(3, 9), ElementsAre("O9100.nc 2:4-2:6"));
    EXPECT_TRUE(session.result("textDocument/definition", at(6, 5)).is_null());
    EXPECT_THAT(definition(1, 1), ElementsAre("O1.nc 1:0-1:2"));
}

TEST_F(LspNames, ListTheCallsOfAProgramInAllFiles) {
    session.folder.write("O9100.nc", macro);
    session.folder.write("O2.nc", "%\nO2\nG65P9100A1.\nM30\n%\n");
    session.folder.write("O3.nc", "%\nO3\nG65P9300\nM30\n%\n");
    open("O1.nc", caller, "fanuc");
    EXPECT_THAT(references(3, 5, false),
                UnorderedElementsAre("O1.nc 3:4-3:8", "O1.nc 4:4-4:8", "O2.nc 2:4-2:8"));
    EXPECT_THAT(references(3, 5, true),
                UnorderedElementsAre("O9100.nc 1:0-1:5", "O1.nc 3:4-3:8", "O1.nc 4:4-4:8", "O2.nc 2:4-2:8"));
}

TEST_F(LspNames, FollowATextThatIsTypedAndAFileThatChanges) {
    session.folder.write("O9100.nc", macro);
    open("O1.nc", caller, "fanuc");
    session.change("O1.nc", "%\nO1\nG65P9100\nG65P9101\nM30\n%\n", 2);
    session.open("O9101.nc", "%\nO9101\nM98P1\nM99\n%\n", "fanuc");
    EXPECT_THAT(definition(3, 5), ElementsAre("O9101.nc 1:0-1:5"));
    EXPECT_THAT(references(1, 1, false), ElementsAre("O9101.nc 2:4-2:5"));
    session.change("O9101.nc", "%\nO9102\nM99\n%\n", 2);
    EXPECT_TRUE(session.result("textDocument/definition", at(3, 5)).is_null());
}

TEST_F(LspNames, LeadFromAVariableToItsStoresHereOrInOtherFiles) {
    session.folder.write("O9100.nc", macro);
    open("O1.nc", "%\nO1\nG65P9100\nG0X#100\n#500=#5041\n#500=#500+1\nM30\n%\n", "fanuc");
    EXPECT_THAT(definition(3, 5), ElementsAre("O9100.nc 3:0-3:4"));
    EXPECT_THAT(definition(5, 7), ElementsAre("O1.nc 4:0-4:4", "O1.nc 5:0-5:4"));
    EXPECT_THAT(references(3, 5, false),
                ElementsAre("O1.nc 3:3-3:7", "O9100.nc 2:7-2:11", "O9100.nc 3:0-3:4"));
    EXPECT_TRUE(session.result("textDocument/definition", at(4, 7)).is_null());
}

TEST_F(LspNames, KeepLocalVariablesToTheirPrograms) {
    session.folder.write("O9100.nc", macro);
    open("O1.nc", "%\nO1\n#1=5\nG0X#1\nM98P2\nM30\nO2\n#1=7\n#[1]=#1\nM99\n%\n", "fanuc");
    EXPECT_THAT(references(3, 4, false), ElementsAre("O1.nc 2:0-2:2", "O1.nc 3:3-3:5"));
    EXPECT_THAT(references(8, 7, false), ElementsAre("O1.nc 7:0-7:2", "O1.nc 8:0-8:4", "O1.nc 8:5-8:7"));
}

TEST_F(LspNames, FindAllUsesOfATool) {
    open("O1.nc", caller, "fanuc");
    EXPECT_THAT(references(5, 2, false), ElementsAre("O1.nc 5:0-5:5", "O1.nc 8:0-8:4"));
    EXPECT_THAT(references(7, 1, false), ElementsAre("O1.nc 7:0-7:3"));
}

TEST_F(LspNames, HighlightWhatIsReadAndWhatIsWritten) {
    open("O1.nc", "%\nO1\n#1=5\nG0X#1\nM30\n%\n", "fanuc");
    const Json found = session.result("textDocument/documentHighlight", at(2, 1));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0]["kind"], 3);
    EXPECT_EQ(found[1]["kind"], 2);
}

constexpr const char* labels =
    "DEF REAL _LEN=5\nANFANG:\nG1 X=_LEN\nIF R1>5 GOTOF ENDE\nGOTOB ANFANG\nENDE:\nM30\n";

TEST_F(LspNames, OfBlocksAndVariablesAreKnownInSinumerik) {
    open("A.MPF", labels, "sinumerik");
    EXPECT_THAT(definition(3, 15), ElementsAre("A.MPF 5:0-5:4"));
    EXPECT_THAT(references(1, 2, true), ElementsAre("A.MPF 1:0-1:6", "A.MPF 4:6-4:12"));
    EXPECT_THAT(definition(2, 6), ElementsAre("A.MPF 0:9-0:13"));
}

TEST_F(LspNames, OfProgramsAreKnownInSinumerik) {
    session.folder.write("SUB.SPF", "PROC SUB(REAL B)\nG1 X=B\nRET\n");
    open("A.MPF", "EXTERN SUB(REAL)\nCALL \"SUB\"\nSUB(5)\nM30\n", "sinumerik");
    EXPECT_THAT(definition(1, 7), ElementsAre(testing::StartsWith("SUB.SPF 0:")));
    EXPECT_THAT(definition(2, 1), ElementsAre(testing::StartsWith("SUB.SPF 0:")));
    EXPECT_THAT(definition(2, 4), ElementsAre("SUB.SPF 0:14-0:15"));
    EXPECT_THAT(references(2, 1, false), ElementsAre("A.MPF 1:6-1:9", "A.MPF 2:0-2:3"));
}

TEST_F(LspNames, OfProgramsAndVariablesAreKnownInDinPlus) {
    session.folder.write("SUB.ncs", "%SUB.ncs\nN1 G1 X#__la\nRETURN\n");
    open("A.nc", "%A.nc\nMACHINING\nN1 #l1=5\nN2 L\"SUB\" V1 LA5\nN3 G1 X#l1\nN4 M30\nEND\n", "dinplus");
    EXPECT_THAT(definition(3, 6), ElementsAre(testing::StartsWith("SUB.ncs 0:")));
    EXPECT_THAT(definition(3, 13), ElementsAre("SUB.ncs 1:7-1:12"));
    EXPECT_THAT(definition(4, 8), ElementsAre("A.nc 2:3-2:6"));
    EXPECT_THAT(references(3, 6, false), ElementsAre("A.nc 3:5-3:8"));
    EXPECT_THAT(refusal(4, 8, "_LEN"), HasSubstr("is a number"));
}

TEST_F(LspNames, ChangeWhereThatIsCertain) {
    open("A.MPF", labels, "sinumerik");
    EXPECT_EQ(shown(session.result("textDocument/prepareRename", at(5, 1))), "5:0-5:4");
    EXPECT_THAT(edits(renamed(3, 15, "FERTIG")), ElementsAre("3:14-3:18 FERTIG", "5:0-5:4 FERTIG"));
    EXPECT_THAT(edits(renamed(2, 6, "_WIDTH")), ElementsAre("0:9-0:13 _WIDTH", "2:5-2:9 _WIDTH"));
}

TEST_F(LspNames, StayWhereTheNewOneMeansSomethingElse) {
    open("A.MPF", labels, "sinumerik");
    EXPECT_THAT(refusal(3, 15, "ANFANG"), HasSubstr("stands in the program already"));
    EXPECT_THAT(refusal(3, 15, "WHILE"), HasSubstr("is a word of the language"));
    EXPECT_THAT(refusal(3, 15, "5TH"), HasSubstr("is no name"));
    EXPECT_THAT(refusal(2, 6, "G54"), HasSubstr("would be read in another way"));
    EXPECT_THAT(refusal(3, 4, "R2"), HasSubstr("is a number that the control or other programs know"));
    const Json asked = session.ask("textDocument/prepareRename", at(3, 4));
    EXPECT_THAT(asked["error"]["message"].get<std::string>(), HasSubstr("other programs know"));
    EXPECT_TRUE(session.result("textDocument/prepareRename", at(6, 1)).is_null());
}

TEST_F(LspNames, StayWhereTheOldOneStandsInWhatNobodyFollows) {
    open("A.MPF", "START:\nMSG(\"TO START\")\nGOTOB START\n", "sinumerik");
    EXPECT_THAT(refusal(0, 1, "BEGINNING"), HasSubstr("stands in line 2, too"));
}

TEST_F(LspNames, TellWhoCallsAndWhoIsCalled) {
    session.folder.write("O9100.nc", macro);
    session.folder.write("O2.nc", "%\nO2\nG65P9100A1.\nM98P1\nM30\n%\n");
    open("O1.nc", caller, "fanuc");
    const Json items = session.result("textDocument/prepareCallHierarchy", at(3, 5));
    ASSERT_EQ(items.size(), 1U);
    EXPECT_EQ(items[0]["name"], "O9100");
    std::vector<std::string> callers;
    for (const Json& call : session.result("callHierarchy/incomingCalls", {{"item", items[0]}})) {
        std::string text = call["from"]["name"];
        for (const Json& range : call["fromRanges"]) text += " " + shown(range);
        callers.push_back(text);
    }
    EXPECT_THAT(callers, UnorderedElementsAre("O1 3:4-3:8 4:4-4:8", "O2 2:4-2:8"));
    const Json own = session.result("textDocument/prepareCallHierarchy", at(5, 1));
    EXPECT_EQ(own[0]["name"], "O1");
    const Json called = session.result("callHierarchy/outgoingCalls", {{"item", own[0]}});
    ASSERT_EQ(called.size(), 1U);
    EXPECT_EQ(called[0]["to"]["name"], "O9100");
    EXPECT_EQ(called[0]["fromRanges"].size(), 2U);
}

TEST_F(LspNames, OfItemsThatAreGoneLeadNowhere) {
    open("O1.nc", caller, "fanuc");
    const Json gone = {{"item", {{"data", {{"path", "/nowhere"}, {"program", 3}}}}}};
    EXPECT_THAT(session.result("callHierarchy/incomingCalls", gone), IsEmpty());
    EXPECT_THAT(session.result("callHierarchy/outgoingCalls", gone), IsEmpty());
    EXPECT_EQ(session.ask("callHierarchy/incomingCalls", Json::object())["error"]["code"], -32602);
}

} // namespace
} // namespace maclint::test
