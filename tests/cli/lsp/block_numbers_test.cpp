//! Numbers of blocks: definition, references, another number, and all of them anew.
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

constexpr const char* jumps = "%\nO1\nIF[#1EQ1]GOTO50\nG0X1.\nGOTO50\nN50G0X2.\nM30\n%\n";

class LspBlockNumbers : public testing::Test {
  protected:
    void open(const std::string& text) {
        session.begin({{"workspace", {{"workspaceEdit", {{"documentChanges", true}}}}}});
        session.open("O1.nc", text, "fanuc");
    }
    Json at(int line, int character) const {
        return {{"textDocument", {{"uri", session.uri("O1.nc")}}}, {"position", place(line, character)}};
    }
    Json renamed(int line, int character, const std::string& name) {
        Json params = at(line, character);
        params["newName"] = name;
        return session.ask("textDocument/rename", params);
    }
    static std::vector<std::string> ranges(const Json& places) {
        std::vector<std::string> all;
        for (const Json& each : places) all.push_back(shown(each["range"]));
        return all;
    }
    /// "5:1-5:3 60", an edit each.
    static std::vector<std::string> edits(const Json& edit) {
        std::vector<std::string> all;
        for (const Json& each : edit["documentChanges"][0]["edits"])
            all.push_back(shown(each["range"]) + " " + each["newText"].get<std::string>());
        return all;
    }

    ScriptedSession session;
};

TEST_F(LspBlockNumbers, LeadFromAJumpToItsBlock) {
    open(jumps);
    EXPECT_EQ(shown(session.result("textDocument/definition", at(2, 14))["range"]), "5:1-5:3");
    EXPECT_TRUE(session.result("textDocument/definition", at(3, 1)).is_null());
}

TEST_F(LspBlockNumbers, AreNamedByAllJumpsToThem) {
    open(jumps);
    Json params = at(5, 2);
    params["context"] = {{"includeDeclaration", false}};
    EXPECT_THAT(ranges(session.result("textDocument/references", params)),
                ElementsAre("2:13-2:15", "4:4-4:6"));
    EXPECT_THAT(ranges(session.result("textDocument/documentHighlight", at(5, 2))),
                ElementsAre("5:1-5:3", "2:13-2:15", "4:4-4:6"));
}

TEST_F(LspBlockNumbers, ChangeTogetherWithTheJumps) {
    open(jumps);
    EXPECT_EQ(shown(session.result("textDocument/prepareRename", at(4, 5))), "4:4-4:6");
    EXPECT_THAT(edits(renamed(4, 5, "N60")["result"]),
                ElementsAre("2:13-2:15 60", "4:4-4:6 60", "5:1-5:3 60"));
}

TEST_F(LspBlockNumbers, TakeNoNumberThatAnotherBlockHasAndNoWord) {
    open("%\nO1\nGOTO50\nN40G0X1.\nN50G0X2.\nGOTO70\nM30\n%\n");
    EXPECT_THAT(renamed(2, 5, "40")["error"]["message"].get<std::string>(),
                HasSubstr("has the number 40 already"));
    EXPECT_THAT(renamed(2, 5, "70")["error"]["message"].get<std::string>(), HasSubstr("which no block has"));
    EXPECT_THAT(renamed(2, 5, "FIRST")["error"]["message"].get<std::string>(),
                HasSubstr("no number of a block"));
    EXPECT_THAT(renamed(2, 5, "0")["error"]["message"].get<std::string>(), HasSubstr("no number of a block"));
}

TEST_F(LspBlockNumbers, StayWhereAComputedJumpMayNameThem) {
    open("%\nO1\nGOTO#1\nGOTO50\nN50G0X2.\nM30\n%\n");
    EXPECT_TRUE(session.result("textDocument/prepareRename", at(3, 5)).is_null());
    const Json answer = session.ask("workspace/executeCommand",
                                    {{"command", "maclint.renumber"}, {"arguments", {session.uri("O1.nc")}}});
    EXPECT_THAT(answer["error"]["message"].get<std::string>(), HasSubstr("line 3: "));
}

TEST_F(LspBlockNumbers, StayWhereAnotherFileNamesThem) {
    session.folder.write("O2.nc", "%\nO2\nM98P1Q50\nM30\n%\n");
    open(jumps);
    EXPECT_THAT(renamed(5, 2, "60")["error"]["message"].get<std::string>(), HasSubstr("O2.nc line 3"));
}

TEST_F(LspBlockNumbers, AreWrittenAnewFromAStartByAStep) {
    open(jumps);
    const Json edit =
        session.result("workspace/executeCommand",
                       {{"command", "maclint.renumber"}, {"arguments", {session.uri("O1.nc"), 100, 10}}});
    EXPECT_THAT(edits(edit), ElementsAre("2:13-2:15 100", "4:4-4:6 100", "5:1-5:3 100"));
    const Json refused = session.ask("workspace/executeCommand", {{"command", "maclint.renumber"},
                                                                  {"arguments", {session.uri("O1.nc"), 0}}});
    EXPECT_THAT(refused["error"]["message"].get<std::string>(), HasSubstr("whole numbers from 1 on"));
}

} // namespace
} // namespace maclint::test
