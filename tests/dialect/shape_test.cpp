//! A block and its shape parse to the same tree: remembered trees are the trees.
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/dialect/fanuc/shape.hpp"
#include "analyzer/syntax/tree.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace maclint::fanuc {
namespace {

std::string tree_of(std::string_view text) {
    syntax::Tree tree;
    syntax::parse(grammar, text, tree);
    std::string printed = syntax::s_expression(grammar, tree);
    for (const syntax::Node& node : tree.nodes)
        printed += ' ' + std::to_string(node.span.begin) + '-' + std::to_string(node.span.end);
    return printed;
}

void expect_same_tree(std::string_view block) {
    std::string shape;
    shape_of(block, shape);
    EXPECT_EQ(tree_of(block), tree_of(shape)) << block;
}

TEST(Shape, KeepsTheTreeOfEveryKindOfBlock) {
    for (const std::string_view block :
         {"N2IF[#1EQ10]GOTO1", "X - [ #12 ] Y.5", "/2 G0 X1", "/0 G0 X1", "#101=#[#3+5]*2.5(TEXT 12 [])",
          "Z3./M14", "WHILE[#1LT5]DO1 (LOOP", "G65P9010A#1B-#[#2+1]", "DPRNT[X#100[53]*Y12]", "O1234(TITLE)",
          "O0 N0", "ZI#23 YI5", "IF #1EQ2 GOTO5", "#1=ATAN[#2]/[3]", "X#1/2", "SETVN 100[A1,B2]",
          "#_ABSKP[1]", "#1=[[#2+3", "GO1 X1O5"})
        expect_same_tree(block);
}

TEST(Shape, KeepsTheTreeOfEveryLineOfRealMacros) {
    const std::filesystem::path folder = std::filesystem::path(MACLINT_SHARED) / "corpus" / "fanuc-macro";
    if (!std::filesystem::is_directory(folder))
        GTEST_SKIP() << "the corpus of real programs is not beside the project";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        constexpr std::size_t longest = 400;
        for (std::string line; std::getline(file, line);)
            if (line.size() < longest) expect_same_tree(line);
    }
}

} // namespace
} // namespace maclint::fanuc
