//! The cases of the grammars' own test corpora through our own printer: the committed parsers do what the
//! grammars say.
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/syntax/tree.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

extern "C" const TSLanguage* tree_sitter_dinplus(void);
extern "C" const TSLanguage* tree_sitter_sinumerik(void);

namespace maclint {
namespace {

/// One case of a tree-sitter test file.
struct Case {
    std::string name, text, tree;
    bool error;
};

std::string without_blanks(std::string_view text) {
    std::string out;
    for (const char c : text)
        if (c != ' ' && c != '\n' && c != '\t') out += c;
    return out;
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

std::vector<Case> cases_in(const std::filesystem::path& path) {
    const auto is_rule = [](const std::string& line, char c) {
        return line.size() >= 3 && line.find_first_not_of(c) == std::string::npos;
    };
    const std::vector<std::string> lines = lines_of(path);
    std::vector<Case> cases;
    for (std::size_t i = 0; i < lines.size();) {
        if (!is_rule(lines[i], '=')) {
            ++i;
            continue;
        }
        Case one{"", "", "", false};
        for (++i; i < lines.size() && !is_rule(lines[i], '='); ++i) {
            if (lines[i] == ":error")
                one.error = true;
            else
                one.name += lines[i];
        }
        for (++i; i < lines.size() && !is_rule(lines[i], '-'); ++i) one.text += lines[i] + '\n';
        for (++i; i < lines.size() && !is_rule(lines[i], '='); ++i) one.tree += lines[i];
        if (!one.text.empty()) one.text.pop_back(); // the line end before the rule is not part of the text
        cases.push_back(std::move(one));
    }
    return cases;
}

void expect_all_cases(syntax::Grammar grammar, const std::filesystem::path& corpus) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
        for (const Case& one : cases_in(entry.path())) {
            syntax::Tree tree;
            syntax::parse(grammar, one.text, tree);
            ++count;
            EXPECT_EQ(tree.has_error, one.error) << entry.path().filename() << ": " << one.name;
            if (one.error) continue;
            EXPECT_EQ(without_blanks(syntax::s_expression(grammar, tree)), without_blanks(one.tree))
                << entry.path().filename() << ": " << one.name;
        }
    }
    EXPECT_GT(count, 20U);
}

TEST(FanucGrammar, AllCasesOfItsCorpusParseAsWritten) {
    expect_all_cases(fanuc::grammar, MACLINT_SOURCE_DIR "/grammar/fanuc/test/corpus");
}

TEST(DinPlusGrammar, AllCasesOfItsCorpusParseAsWritten) {
    expect_all_cases(tree_sitter_dinplus, MACLINT_SOURCE_DIR "/grammar/dinplus/test/corpus");
}

TEST(SinumerikGrammar, AllCasesOfItsCorpusParseAsWritten) {
    expect_all_cases(tree_sitter_sinumerik, MACLINT_SOURCE_DIR "/grammar/sinumerik/test/corpus");
}

TEST(FanucGrammar, EveryKindAndFieldThatLoweringNamesExists) {
    EXPECT_NO_FATAL_FAILURE({
        syntax::Tree tree;
        syntax::parse(fanuc::grammar, "IF[#1EQ2]THEN#3=SIN[#4]", tree);
        ASSERT_FALSE(tree.has_error);
        const auto has = [&](fanuc::Kind kind) {
            for (const syntax::Node& node : tree.nodes)
                if (fanuc::kind_of(node) == kind) return true;
            return false;
        };
        EXPECT_TRUE(has(fanuc::Kind::if_statement));
        EXPECT_TRUE(has(fanuc::Kind::comparison));
        EXPECT_TRUE(has(fanuc::Kind::call));
        EXPECT_TRUE(has(fanuc::Kind::operation));
    });
}

} // namespace
} // namespace maclint
