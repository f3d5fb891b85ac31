//! What is published while somebody types.
#include "tests/cli/lsp/scripted_session.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string jump_nowhere = "%\nO1001 (BAD)\nG0 X1.\nGOTO 99\nM30\n%\n";
const std::string repaired = "%\nO1001 (BAD)\nG0 X1.\nM30\n%\n";

class LspDiagnostics : public testing::Test {
  protected:
    ScriptedSession session;
};

TEST_F(LspDiagnostics, ComeForTheTextOfTheEditorAndGoWhenItIsRepaired) {
    session.begin(Json::object());
    session.open("O1001.nc", jump_nowhere, "fanuc");
    const Json found = session.diagnostics("O1001.nc", 1);
    EXPECT_THAT(shown_findings(found), ElementsAre("MAC301 3:0-3:7"));
    EXPECT_EQ(found[0]["severity"], 1);
    EXPECT_EQ(found[0]["source"], "maclint");
    EXPECT_THAT(found[0]["message"].get<std::string>(), HasSubstr("GOTO 99"));
    session.send(
        "textDocument/didChange",
        {{"textDocument", {{"uri", session.uri("O1001.nc")}, {"version", 2}}},
         {"contentChanges", {{{"range", {{"start", place(3, 0)}, {"end", place(4, 0)}}}, {"text", ""}}}}});
    EXPECT_THAT(session.diagnostics("O1001.nc", 2), IsEmpty());
}

TEST_F(LspDiagnostics, CountColumnsAsTheClientDoes) {
    const std::string text = "%\nO1001\n(\xF0\x9F\x94\xA9\xC3\xA4) GOTO 99\nM30\n%\n";
    session.begin(Json::object());
    session.open("O1001.nc", text, "fanuc");
    EXPECT_THAT(shown_findings(session.diagnostics("O1001.nc", 1)), ElementsAre("MAC301 2:6-2:13"));
    ScriptedSession other;
    other.begin({{"general", {{"positionEncodings", {"utf-8"}}}}});
    other.open("O1001.nc", text, "fanuc");
    EXPECT_THAT(shown_findings(other.diagnostics("O1001.nc", 1)), ElementsAre("MAC301 2:9-2:16"));
}

TEST_F(LspDiagnostics, ComeForAllProgramsOfTheFolderWithProgress) {
    session.folder.write("programs/O1001.nc", jump_nowhere);
    session.folder.write("programs/O1002.nc", "%\nO1002 (GOOD)\nG0 X1.\nM30\n%\n");
    session.begin({{"window", {{"workDoneProgress", true}}}});
    EXPECT_THAT(shown_findings(session.diagnostics("programs/O1001.nc", {})), ElementsAre("MAC301 3:0-3:7"));
    EXPECT_EQ(session.next("window/workDoneProgress/create")["params"]["token"],
              session.next("$/progress")["params"]["token"]);
    session.folder.write("programs/O1001.nc", repaired);
    session.send("workspace/didChangeWatchedFiles",
                 {{"changes", {{{"uri", session.uri("programs/O1001.nc")}, {"type", 2}}}}});
    EXPECT_THAT(session.diagnostics("programs/O1001.nc", {}), IsEmpty());
    for (const Json& message : session.said())
        if (message.value("method", "") == "textDocument/publishDiagnostics") {
            EXPECT_NE(message["params"]["uri"], session.uri("programs/O1002.nc"));
        }
}

TEST_F(LspDiagnostics, SeeTheCallerInAnotherFileAndLeadThere) {
    session.folder.write("O1.nc", "%\nO1\nG65 P9100 B2.\nM30\n%\n");
    session.begin(Json::object());
    session.open("O9100.nc", "%\nO9100\nG0 X#1\nG1 Z[10./#1] F100.\nM99\n%\n", "fanuc");
    const Json found = session.diagnostics("O9100.nc", 1);
    ASSERT_FALSE(found.empty());
    std::string places;
    for (const Json& diagnostic : found)
        for (const Json& related : diagnostic.value("relatedInformation", Json::array()))
            places += related["location"]["uri"].get<std::string>() + " ";
    EXPECT_THAT(places, HasSubstr(session.uri("O1.nc")));
}

TEST_F(LspDiagnostics, KeepToSuppressionsConfigurationAndBaseline) {
    session.folder.write(".maclint.json", R"({"severity": {"MAC301": "note"}})");
    session.begin(Json::object());
    session.open("O1001.nc", jump_nowhere, "fanuc");
    EXPECT_EQ(session.diagnostics("O1001.nc", 1)[0]["severity"], 3);
    session.change("O1001.nc", "%\nO1001\nGOTO 99 (MACLINT ALLOW MAC301)\nM30\n%\n", 2);
    EXPECT_THAT(session.diagnostics("O1001.nc", 2), IsEmpty());
    session.folder.write(".maclint.json", R"({"ignore": ["MAC301"]})");
    session.send("workspace/didChangeWatchedFiles",
                 {{"changes", {{{"uri", session.uri(".maclint.json")}, {"type", 2}}}}});
    session.change("O1001.nc", jump_nowhere, 3);
    EXPECT_THAT(session.diagnostics("O1001.nc", 3), IsEmpty());
}

TEST_F(LspDiagnostics, TellOnceOfAConfigurationThatIsWrong) {
    session.folder.write(".maclint.json", R"({"selct": []})");
    session.begin(Json::object());
    session.open("O1001.nc", jump_nowhere, "fanuc");
    const Json message = session.next("window/showMessage");
    EXPECT_THAT(message["params"]["message"].get<std::string>(), HasSubstr("selct"));
    session.change("O1001.nc", jump_nowhere, 2);
    session.change("O1001.nc", jump_nowhere, 3);
    (void)session.result("shutdown", Json());
    int told = 0;
    for (const Json& said : session.said()) told += said.value("method", "") == "window/showMessage" ? 1 : 0;
    EXPECT_EQ(told, 1);
}

TEST_F(LspDiagnostics, ReadNothingOutsideForASettingOfTheFolder) {
    const TemporaryFolder elsewhere;
    elsewhere.write("secret.json", R"({"ignore": ["MAC301"]})");
    session.folder.write(".maclint.json",
                         "{\"extends\": \"" + (elsewhere.path() / "secret.json").string() + "\"}");
    session.begin(Json::object());
    EXPECT_THAT(session.next("window/showMessage")["params"]["message"].get<std::string>(),
                HasSubstr("lies outside"));
}

TEST_F(LspDiagnostics, TakeTheLanguageThatTheEditorNames) {
    const std::string text = "N1 G1 X10 Z5\nN2 G850 X2\n";
    session.begin(Json::object());
    session.open("part.nc", text, "dinplus");
    const auto as_dinplus = shown_findings(session.diagnostics("part.nc", 1));
    session.send("textDocument/didClose", {{"textDocument", {{"uri", session.uri("part.nc")}}}});
    session.open("part2.nc", text, "plaintext");
    EXPECT_NE(as_dinplus, shown_findings(session.diagnostics("part2.nc", 1)));
}

TEST_F(LspDiagnostics, GoOnWithoutAFolderThatHasVanishedAndWithTextsThatAreNoFiles) {
    const std::filesystem::path gone = session.folder.path() / "programs";
    session.begin(Json::object());
    std::filesystem::remove_all(session.folder.path() / ".git");
    session.send("workspace/didChangeWorkspaceFolders",
                 {{"event",
                   {{"added", {{{"uri", "file://" + gone.string()}, {"name", "gone"}}}},
                    {"removed", Json::array()}}}});
    session.send("textDocument/didOpen", {{"textDocument",
                                           {{"uri", "untitled:Untitled-1"},
                                            {"languageId", "fanuc"},
                                            {"version", 1},
                                            {"text", jump_nowhere}}}});
    Json published;
    do published = session.next("textDocument/publishDiagnostics")["params"];
    while (published.is_object() && published["uri"] != "untitled:Untitled-1");
    EXPECT_THAT(shown_findings(published["diagnostics"]), ElementsAre("MAC301 3:0-3:7"));
}

TEST_F(LspDiagnostics, OfAClosedTextAreThoseOfItsFile) {
    session.folder.write("O1001.nc", repaired);
    session.begin(Json::object());
    session.open("O1001.nc", jump_nowhere, "fanuc");
    EXPECT_EQ(session.diagnostics("O1001.nc", 1).size(), 1U);
    session.send("textDocument/didClose", {{"textDocument", {{"uri", session.uri("O1001.nc")}}}});
    Json published;
    do published = session.diagnostics("O1001.nc", {});
    while (!published.empty());
    EXPECT_THAT(published, IsEmpty());
}

} // namespace
} // namespace maclint::test
