//! Named contours of DIN PLUS: where they are, which cycles ask for them, another name.
#include "tests/cli/lsp/scripted_session.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class LspContours : public testing::Test {
  protected:
    LspContours() {
        session.begin(Json::object());
        open("");
    }
    void open(const std::string& more) {
        session.open(
            "a.ncs",
            "%a.nc\nFINISHED\nN1 G0 X60 Z0\nN2 G1 Z-40\nAUXIL_CONTOUR ID\"SEAT\"\nN3 G0 X60 Z-10\n" + more +
                "AUXIL_CONTOUR ID\"RING\"\nN4 G0 X50 Z-10\nMACHINING\nN10 T1\nN11 G810 ID\"SEAT\" P2\n"
                "N12 G810 ID\"RING\" P2\nN13 M30\nEND\n",
            "dinplus");
    }
    Json at(int line, int character) const {
        return {{"textDocument", {{"uri", session.uri("a.ncs")}}}, {"position", place(line, character)}};
    }
    std::vector<std::string> ranges(const std::string& method, Json params) {
        std::vector<std::string> all;
        for (const Json& each : session.result("textDocument/" + method, std::move(params)))
            all.push_back(shown(each["range"]));
        return all;
    }
    Json renamed(int line, int character, const std::string& name) {
        Json params = at(line, character);
        params["newName"] = name;
        return session.ask("textDocument/rename", params);
    }
    ScriptedSession session;
};

TEST_F(LspContours, AreFoundFromTheCyclesThatAskForThem) {
    EXPECT_THAT(ranges("definition", at(10, 14)), ElementsAre("4:17-4:21"));
    EXPECT_THAT(ranges("documentHighlight", at(4, 19)), ElementsAre("4:17-4:21", "10:12-10:16"));
    Json params = at(4, 19);
    params["context"] = {{"includeDeclaration", false}};
    EXPECT_THAT(ranges("references", params), ElementsAre("10:12-10:16"));
    params["context"] = {{"includeDeclaration", true}};
    EXPECT_THAT(ranges("references", params), ElementsAre("4:17-4:21", "10:12-10:16"));
}

TEST_F(LspContours, GetAnotherNameWhereverItStands) {
    EXPECT_EQ(shown(session.result("textDocument/prepareRename", at(10, 14))), "10:12-10:16");
    std::vector<std::string> edits;
    const Json answer = renamed(10, 14, "SEAT 2");
    for (const Json& edit : answer["result"]["changes"][session.uri("a.ncs")])
        edits.push_back(shown(edit["range"]) + " " + edit["newText"].get<std::string>());
    EXPECT_THAT(edits, ElementsAre("4:17-4:21 SEAT 2", "10:12-10:16 SEAT 2"));
}

TEST_F(LspContours, AreNotGivenNamesOfOthersOrNone) {
    const auto refusal = [&](const std::string& name) {
        return renamed(10, 14, name)["error"]["message"].get<std::string>();
    };
    EXPECT_THAT(refusal("RING"), HasSubstr("is the name of a contour already"));
    EXPECT_THAT(refusal("A\"B"), HasSubstr("is no name of a contour"));
    EXPECT_THAT(refusal(" "), HasSubstr("is no name of a contour"));
    open("N5 L\"MORE\"\n");
    EXPECT_THAT(renamed(4, 19, "SEAT 2")["error"]["message"].get<std::string>(),
                HasSubstr("Subprograms describe contours of this program, too"));
}

} // namespace
} // namespace maclint::test
