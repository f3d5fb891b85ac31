//! Formatting: only what the configuration has chosen.
#include "tests/cli/lsp/scripted_session.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class LspFormatting : public testing::Test {
  protected:
    std::vector<std::string> edits(const std::string& method, const Json& more) {
        Json params = {{"textDocument", {{"uri", session.uri("O1.nc")}}},
                       {"options", {{"tabSize", 4}, {"insertSpaces", true}}}};
        params.update(more);
        std::vector<std::string> all;
        for (const Json& edit : session.result("textDocument/" + method, params))
            all.push_back(shown(edit["range"]) + " '" + edit["newText"].get<std::string>() + "'");
        return all;
    }
    ScriptedSession session;
};

TEST_F(LspFormatting, ChangesNothingUnasked) {
    session.begin(Json::object());
    session.open("O1.nc", "O1\nN10G1  X5.\nM30\n", "fanuc");
    EXPECT_THAT(edits("formatting", Json::object()), IsEmpty());
}

TEST_F(LspFormatting, SetsTheBlanksThatTheConfigurationHasChosen) {
    session.folder.write(".maclint.json", R"({"spacing": {"words": "one", "operators": "one"}})");
    const Json server = session.begin(Json::object());
    EXPECT_TRUE(server["capabilities"]["documentFormattingProvider"]);
    EXPECT_TRUE(server["capabilities"]["documentRangeFormattingProvider"]);
    session.open("O1.nc", "O1\nN10G1  X5.\n#1=2\nM30\n", "fanuc");
    EXPECT_THAT(edits("formatting", Json::object()),
                ElementsAre("1:3-1:3 ' '", "1:5-1:7 ' '", "2:2-2:2 ' '", "2:3-2:3 ' '"));
    const Json range = {{"range", {{"start", place(2, 0)}, {"end", place(2, 1)}}}};
    EXPECT_THAT(edits("rangeFormatting", range), ElementsAre("2:2-2:2 ' '", "2:3-2:3 ' '"));
}

TEST_F(LspFormatting, OfWhatIsNoProgramIsEmpty) {
    session.folder.write(".maclint.json", R"({"spacing": {"words": "none"}})");
    session.begin(Json::object());
    session.open("O1.nc", "# Notes\n\nSome words that nobody takes for a program.\n", "markdown");
    EXPECT_THAT(edits("formatting", Json::object()), IsEmpty());
}

} // namespace
} // namespace maclint::test
