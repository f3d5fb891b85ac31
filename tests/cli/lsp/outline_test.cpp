//! The outline of a file, and what folds.
#include "tests/cli/lsp/scripted_session.hpp"

#include <chrono>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string plate = "%\n"
                          "O1000(PLATE)\n"
                          "N10 T5 M6 (DRILL 8.5)\n"
                          "WHILE[#1LT2]DO1\n"
                          "#1=#1+1\n"
                          "END1\n"
                          "T12 M6\n"
                          "M30\n"
                          "O9100\n"
                          "M99\n"
                          "%\n";

class LspOutline : public testing::Test {
  protected:
    Json ask(const std::string& method, const std::string& name) {
        return session.result("textDocument/" + method, {{"textDocument", {{"uri", session.uri(name)}}}});
    }
    /// "T5 (DRILL 8.5) 2:4-2:6", children behind.
    static void list(const Json& symbols, std::vector<std::string>& out) {
        for (const Json& symbol : symbols) {
            const std::string detail = symbol.value("detail", "");
            out.push_back(symbol["name"].get<std::string>() + (detail.empty() ? "" : " (" + detail + ")") +
                          " " + shown(symbol["selectionRange"]));
            list(symbol.value("children", Json::array()), out);
        }
    }
    const Json trees = {
        {"textDocument", {{"documentSymbol", {{"hierarchicalDocumentSymbolSupport", true}}}}}};
    ScriptedSession session;
};

TEST_F(LspOutline, HasProgramsAndTheirToolsWithTheCommentBeside) {
    session.begin(trees);
    session.open("O1000.nc", plate, "fanuc");
    std::vector<std::string> names;
    list(ask("documentSymbol", "O1000.nc"), names);
    EXPECT_THAT(names, ElementsAre("O1000 (PLATE) 1:0-1:5", "T5 (DRILL 8.5) 2:4-2:6", "T12 6:0-6:3",
                                   "O9100 8:0-8:5"));
}

TEST_F(LspOutline, IsAListForClientsWithoutTrees) {
    session.begin(Json::object());
    session.open("O1000.nc", plate, "fanuc");
    const Json symbols = ask("documentSymbol", "O1000.nc");
    ASSERT_EQ(symbols.size(), 4U);
    EXPECT_EQ(symbols[1]["containerName"], "O1000");
    EXPECT_EQ(symbols[1]["location"]["uri"], session.uri("O1000.nc"));
}

TEST_F(LspOutline, HasSectionsAndNamesOfBlocksWhereTheLanguageHasThem) {
    session.begin(trees);
    session.open("a.MPF", "G0 X10\nSTART: R1=R2+1\nIF R1<5 GOTOB START\nM30\n", "sinumerik");
    std::vector<std::string> names;
    list(ask("documentSymbol", "a.MPF"), names);
    ASSERT_EQ(names.size(), 2U);
    EXPECT_TRUE(names[1].starts_with("START 1:0")) << names[1];
}

TEST_F(LspOutline, HasTheNamesOfContours) {
    session.begin(trees);
    session.open("a.ncs",
                 "%a.nc\nAUXIL_CONTOUR ID\"SEAT\"\nN3 G0 X60 Z-10\nMACHINING\nN10 T1\nN12 M30\nEND\n",
                 "dinplus");
    std::vector<std::string> names;
    list(ask("documentSymbol", "a.ncs"), names);
    EXPECT_THAT(names, testing::Contains("SEAT 1:14-1:22"));
}

TEST_F(LspOutline, FoldsProgramsAndLoops) {
    session.begin(Json::object());
    session.open("O1000.nc", plate, "fanuc");
    std::vector<std::string> folds;
    for (const Json& fold : ask("foldingRange", "O1000.nc"))
        folds.push_back(fold["startLine"].dump() + "-" + fold["endLine"].dump());
    EXPECT_THAT(folds, ElementsAre("1-7", "3-5", "8-9"));
}

TEST_F(LspOutline, OfWhatIsNoProgramIsEmpty) {
    session.begin(trees);
    session.open("README.md", "# Notes\n\nSome words that nobody takes for a program.\n", "markdown");
    EXPECT_THAT(ask("documentSymbol", "README.md"), IsEmpty());
    EXPECT_THAT(ask("foldingRange", "README.md"), IsEmpty());
}

} // namespace
} // namespace maclint::test
