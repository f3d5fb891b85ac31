//! Dependencies point one way, between the folders of the analyzer too, and what is right of the program
//! model knows no dialect.
#include "tests/structure/project_files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A folder includes only what stands before it. What is left in analyzer/dataflow/ itself, loops and cycles,
/// stands on the solver. A finder stands in a room of the rules and knows no rule.
constexpr std::string_view finders = "*_finder";
constexpr auto layers = std::to_array<std::string_view>(
    {"grammar/", "analyzer/source/", "analyzer/syntax/", "analyzer/program/", "analyzer/semantics/",
     "analyzer/dialect/", "analyzer/flow/", "analyzer/machine/", "analyzer/dataflow/domain/",
     "analyzer/dataflow/facts/", "analyzer/dataflow/solver/", "analyzer/dataflow/", "analyzer/workspace/",
     "analyzer/execution/", "analyzer/queries/", finders, "rules/", "cli/"});

constexpr std::array<std::string_view, 9> dialect_blind = {
    "analyzer/program/",   "analyzer/semantics/", "analyzer/flow/",
    "analyzer/machine/",   "analyzer/dataflow/",  "analyzer/workspace/",
    "analyzer/execution/", "analyzer/queries/",   "rules/"};

constexpr std::array<std::string_view, 5> dialects = {"fanuc", "nct", "haas", "dinplus", "sinumerik"};

/// Position of a path's folder in the layers; their number when it is in none of them.
std::size_t layer_of(std::string_view path) {
    const auto folder = std::ranges::find_if(layers, [&](std::string_view layer) {
        return layer == finders ? is_finder(path) : path.starts_with(layer);
    });
    return static_cast<std::size_t>(folder - layers.begin());
}

bool is_dialect_blind(std::string_view path) {
    return std::any_of(dialect_blind.begin(), dialect_blind.end(),
                       [path](std::string_view folder) { return path.starts_with(folder); });
}

/// `analyzer/dialect/<name>/...`; what lies in analyzer/dialect itself is for all.
bool is_inside_a_dialect(std::string_view include) {
    constexpr std::string_view folder = "analyzer/dialect/";
    return include.starts_with(folder) && include.substr(folder.size()).find('/') != std::string_view::npos;
}

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Does the code name the dialect, in any case? `nct` counts only as a whole word: it is a part of
/// "function".
bool names_dialect(std::string_view code, std::string_view dialect) {
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    for (auto at = code.begin();; ++at) {
        at = std::search(at, code.end(), dialect.begin(), dialect.end(), same);
        if (at == code.end()) return false;
        if (dialect != "nct") return true;
        const auto end = at + static_cast<std::ptrdiff_t>(dialect.size());
        const bool begins = at == code.begin() || !is_word_character(*std::prev(at));
        if (begins && (end == code.end() || !is_word_character(*end))) return true;
    }
}

std::vector<std::string> backward_includes(const std::vector<ProjectFile>& files) {
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        if (layer_of(file.path) == layers.size()) continue;
        for (const std::string& include : quoted_includes(file.text)) {
            const std::size_t layer = layer_of(include);
            if (layer != layers.size() && layer > layer_of(file.path))
                found.push_back(file.path + " includes " + include);
        }
    }
    return found;
}

std::vector<std::string> dialect_includes(const std::vector<ProjectFile>& files) {
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        if (!is_dialect_blind(file.path)) continue;
        for (const std::string& include : quoted_includes(file.text)) {
            if (is_inside_a_dialect(include)) found.push_back(file.path + " includes " + include);
        }
    }
    return found;
}

/// Rules are left out, not their finders: their descriptors explain controls by name and hold example
/// programs.
std::vector<std::string> dialect_names(const std::vector<ProjectFile>& files) {
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        const bool is_rule = file.path.starts_with("rules/") && !is_finder(file.path);
        if (!is_dialect_blind(file.path) || is_rule) continue;
        const std::string code = without_comments(file.text);
        for (const std::string_view dialect : dialects) {
            if (names_dialect(code, dialect)) found.push_back(file.path + " names " + std::string(dialect));
        }
    }
    return found;
}

TEST(Dependencies, EverySourceOfTheAnalyzerStandsInAKnownFolder) {
    for (const ProjectFile& file : sources())
        EXPECT_TRUE(!file.path.starts_with("analyzer/") || layer_of(file.path) < layers.size()) << file.path;
}

TEST(Dependencies, PointFromTheCommandLineToTheGrammarAndNeverBack) {
    EXPECT_THAT(backward_includes(sources()), IsEmpty());
}

TEST(Dependencies, OfFlowDataFlowWorkspaceAndRulesReachNoDialect) {
    EXPECT_THAT(dialect_includes(sources()), IsEmpty());
}

TEST(Dependencies, OfTheProgramModelNameNoDialectInCode) { EXPECT_THAT(dialect_names(sources()), IsEmpty()); }

TEST(DependencyCheck, FindsABackwardInclude) {
    const std::vector<ProjectFile> files = {{"analyzer/flow/graph.cpp", "#include \"rules/rule.hpp\"\n"},
                                            {"rules/registry.cpp", "#include \"analyzer/flow/graph.hpp\"\n"}};
    EXPECT_THAT(backward_includes(files), ElementsAre("analyzer/flow/graph.cpp includes rules/rule.hpp"));
}

TEST(DependencyCheck, FindsABackwardIncludeBetweenFoldersOfTheAnalyzer) {
    const std::vector<ProjectFile> files = {
        {"analyzer/flow/graph.cpp", "#include \"analyzer/dataflow/domain/state.hpp\"\n"},
        {"analyzer/dataflow/domain/state.cpp", "#include \"analyzer/flow/graph.hpp\"\n"}};
    EXPECT_THAT(backward_includes(files),
                ElementsAre("analyzer/flow/graph.cpp includes analyzer/dataflow/domain/state.hpp"));
}

TEST(DependencyCheck, FindsABackwardIncludeWithinDataFlow) {
    const std::vector<ProjectFile> files = {
        {"analyzer/dataflow/domain/value.hpp", "#include \"analyzer/dataflow/facts/read.hpp\"\n"},
        {"analyzer/dataflow/facts/read.hpp", "#include \"analyzer/dataflow/solver/summary.hpp\"\n"},
        {"analyzer/dataflow/solver/transfer.cpp", "#include \"analyzer/dataflow/loops.hpp\"\n"},
        {"analyzer/dataflow/loops.cpp", "#include \"analyzer/dataflow/domain/value.hpp\"\n"}};
    EXPECT_EQ(backward_includes(files).size(), 3U);
}

TEST(DependencyCheck, FindsAFinderThatAsksARuleAndAQueryThatAsksAFinder) {
    const std::vector<ProjectFile> files = {
        {"rules/flow/a_finder.cpp", "#include \"analyzer/queries/a.hpp\"\n#include "
                                    "\"rules/flow/b_finder.hpp\"\n#include \"rules/path.hpp\"\n"},
        {"analyzer/queries/loops/a.cpp", "#include \"rules/flow/a_finder.hpp\"\n"},
        {"rules/flow/a.cpp", "#include \"rules/flow/a_finder.hpp\"\n"}};
    EXPECT_THAT(backward_includes(files),
                ElementsAre("rules/flow/a_finder.cpp includes rules/path.hpp",
                            "analyzer/queries/loops/a.cpp includes rules/flow/a_finder.hpp"));
}

TEST(DependencyCheck, FindsARuleThatReachesIntoADialect) {
    const std::vector<ProjectFile> files = {
        {"rules/flow/a.cpp",
         "#include \"analyzer/dialect/fanuc/codes.hpp\"\n#include \"analyzer/dialect/limits.hpp\"\n"},
        {"cli/a.cpp", "#include \"analyzer/dialect/fanuc/codes.hpp\"\n"}};
    EXPECT_THAT(dialect_includes(files),
                ElementsAre("rules/flow/a.cpp includes analyzer/dialect/fanuc/codes.hpp"));
}

TEST(DependencyCheck, FindsADialectNamedInCodeButNotInAComment) {
    const std::vector<ProjectFile> files = {
        {"analyzer/flow/a.cpp", "// Fanuc looks from here to the end.\n/* haas */ int function;\n"},
        {"analyzer/flow/b.cpp", "if (limits == FanucLimits) return; // not HAAS"},
        {"analyzer/flow/d.cpp", "function(Dialect::nct);"},
        {"analyzer/flow/c.cpp", "auto control = \"// Haas\";"},
        {"rules/flow/e.cpp", "const char* text = \"Haas says\";"},
        {"rules/flow/e_finder.cpp", "return control == haas;"}};
    EXPECT_THAT(dialect_names(files),
                ElementsAre("analyzer/flow/b.cpp names fanuc", "analyzer/flow/d.cpp names nct",
                            "analyzer/flow/c.cpp names haas", "rules/flow/e_finder.cpp names haas"));
}

} // namespace
} // namespace maclint::structure
