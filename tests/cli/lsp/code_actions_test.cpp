//! Fixes, comments that allow, and pages, as actions of an editor.
#include "tests/cli/lsp/scripted_session.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;

class LspCodeActions : public testing::Test {
  protected:
    Json actions(const std::string& name, int line, Json context) {
        return session.result("textDocument/codeAction",
                              {{"textDocument", {{"uri", session.uri(name)}}},
                               {"range", {{"start", place(line, 0)}, {"end", place(line, 1)}}},
                               {"context", std::move(context)}});
    }
    static std::vector<std::string> titles(const Json& actions) {
        std::vector<std::string> all;
        for (const Json& action : actions) all.push_back(action["title"]);
        return all;
    }
    static Json titled(const Json& actions, const std::string& title) {
        const auto found =
            std::ranges::find_if(actions, [&](const Json& action) { return action["title"] == title; });
        return found == actions.end() ? Json::object() : *found;
    }

    ScriptedSession session;
};

TEST_F(LspCodeActions, AllowAFindingByACommentOfTheLanguage) {
    session.begin({{"workspace", {{"workspaceEdit", {{"documentChanges", true}}}}}});
    session.open("O1.nc", "%\nO1\nGOTO 99 ;\nM30\n%\n", "fanuc");
    (void)session.diagnostics("O1.nc", 1);
    const Json action = titled(actions("O1.nc", 2, Json::object()), "Allow MAC301 here");
    const Json& change = action["edit"]["documentChanges"][0];
    EXPECT_EQ(change["textDocument"]["version"], 1);
    EXPECT_EQ(shown(change["edits"][0]["range"]), "2:7-2:7");
    EXPECT_EQ(change["edits"][0]["newText"], " (MACLINT ALLOW MAC301)");
}

TEST_F(LspCodeActions, FixOneFindingOrAllThatAreSafe) {
    session.begin(Json::object());
    session.open("O1.nc", "%\nO1\nG0 X1. (MACLINT ALLOW MAC301)\nM30\n%\n", "fanuc");
    EXPECT_THAT(shown_findings(session.diagnostics("O1.nc", 1)), ElementsAre(HasSubstr("MAC001")));
    const Json all = session.result("textDocument/codeAction",
                                    {{"textDocument", {{"uri", session.uri("O1.nc")}}},
                                     {"range", {{"start", place(0, 0)}, {"end", place(5, 0)}}},
                                     {"context", {{"diagnostics", Json::array()}, {"only", {"quickfix"}}}}});
    ASSERT_GE(all.size(), 2U);
    EXPECT_TRUE(all[0]["isPreferred"].get<bool>());
    EXPECT_EQ(all[0]["edit"]["changes"][session.uri("O1.nc")][0]["newText"], "");
    const Json fix_all = actions("O1.nc", 0, {{"only", {"source.fixAll"}}});
    EXPECT_THAT(titles(fix_all), ElementsAre("Fix all safe findings of maclint"));
    EXPECT_THAT(actions("O1.nc", 0, {{"only", {"refactor"}}}), IsEmpty());
}

TEST_F(LspCodeActions, AreNoneForATextThatHasNotBeenAnalysedYet) {
    session.begin(Json::object());
    session.open("O1.nc", "%\nO1\nGOTO 99\nM30\n%\n", "fanuc");
    (void)session.diagnostics("O1.nc", 1);
    session.send("textDocument/didChange", {{"textDocument", {{"uri", session.uri("O1.nc")}, {"version", 7}}},
                                            {"contentChanges", Json::array()}});
    const Json early = actions("O1.nc", 2, Json::object()); // or just analysed: then of that version
    (void)session.diagnostics("O1.nc", 7);
    EXPECT_THAT(titles(actions("O1.nc", 2, Json::object())),
                IsSupersetOf({"Allow MAC301 here", "Explain MAC301"}));
    EXPECT_TRUE(early.empty() || early.size() > 1);
}

TEST_F(LspCodeActions, ExplainARule) {
    session.begin(Json::object());
    const Json page = session.result("workspace/executeCommand",
                                     {{"command", "maclint.explain"}, {"arguments", {"MAC301"}}});
    EXPECT_THAT(page["markdown"].get<std::string>(), HasSubstr("# MAC301"));
    const Json code =
        session.result("workspace/executeCommand", {{"command", "maclint.explain"}, {"arguments", {"G83"}}});
    EXPECT_THAT(code["markdown"].get<std::string>(), HasSubstr("G83"));
    for (const Json& wrong :
         {Json({{"command", "maclint.explain"}, {"arguments", {"no such thing"}}}),
          Json({{"command", "rm"}, {"arguments", Json::array()}}), Json({{"command", "maclint.explain"}})})
        EXPECT_EQ(session.ask("workspace/executeCommand", wrong)["error"]["code"], -32602) << wrong;
}

} // namespace
} // namespace maclint::test
