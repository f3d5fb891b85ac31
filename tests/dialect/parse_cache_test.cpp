//! A tree taken from the cache is the block's own tree, whatever bytes the block holds.
#include "tests/dialect/cached_trees.hpp"
#include "tests/dialect/reading.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

/// A language, with what random changes of its blocks are made of.
struct Language {
    const test::BlockLanguage& blocks;
    std::string_view marks; ///< bytes that mean something in it
    std::vector<const char*> folders;
};

const Language fanuc_family{test::fanuc_blocks,
                            "()()#<>[]/%\0 1N.,=+-&@\xC3\x84\xEF\xBB\xBF"sv,
                            {MACLINT_SOURCE_DIR "/corpus/fanuc", MACLINT_SOURCE_DIR "/tests/fixtures",
                             MACLINT_SHARED "/corpus/fanuc-macro",
                             MACLINT_SHARED "/reference/seed-programs"}};
const Language din_plus{test::dinplus_blocks,
                        "\"\"[[]]()#;/%\0 \xE2\x80\x9C\xE2\x80\x9D\xC3\x84_$N1=+.,?A"sv,
                        {MACLINT_SOURCE_DIR "/corpus/dinplus", MACLINT_SOURCE_DIR "/tests/fixtures",
                         MACLINT_SHARED "/reference/dinplus-examples",
                         MACLINT_SHARED "/reference/seed-programs"}};

std::set<std::string> blocks_of_corpora(const Language& language) {
    std::set<std::string> blocks;
    for (const char* folder : language.folders) {
        if (!fs::is_directory(folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (!entry.is_regular_file()) continue;
            std::ifstream file(entry.path(), std::ios::binary);
            test::add_blocks(language.blocks, std::string(std::istreambuf_iterator<char>(file), {}), blocks);
        }
    }
    return blocks;
}

/// Blocks of the corpora with up to four random changes, and blocks of nothing but chance.
class RandomBlocks {
  public:
    RandomBlocks(const Language& language, const std::set<std::string>& blocks)
        : language_(language)
        , blocks_(blocks.begin(), blocks.end()) {}

    std::string next() {
        std::string block = random_(4) == 0 ? chance() : changed(blocks_[random_(blocks_.size())]);
        std::erase_if(block, [](char c) { return c == '\n' || c == '\r'; });
        return block;
    }

  private:
    class Random {
      public:
        std::size_t operator()(std::size_t limit) { return generator_() % limit; }

      private:
        std::mt19937 generator_{11};
    };

    char byte() {
        return random_(3) == 0 ? static_cast<char>(random_(256))
                               : language_.marks[random_(language_.marks.size())];
    }

    std::string chance() {
        std::string block(1 + random_(30), ' ');
        for (char& c : block) c = byte();
        return block;
    }

    std::string changed(std::string block) {
        for (std::size_t left = 1 + random_(4); left > 0 && !block.empty(); --left) {
            const std::size_t at = random_(block.size());
            switch (random_(4)) {
            case 0: block.erase(at, 1); break;
            case 1: block.insert(at, 1, byte()); break;
            case 2: block[at] = byte(); break;
            default: {
                const std::string& other = blocks_[random_(blocks_.size())];
                block.insert(at, other.substr(random_(other.size()), 1 + random_(6)));
                break;
            }
            }
        }
        return block;
    }

    const Language& language_;
    std::vector<std::string> blocks_;
    Random random_;
};

void expect_own_trees(test::TreeComparison& comparison, const std::set<std::string>& blocks) {
    for (const std::string& block : blocks)
        if (const auto difference = comparison.difference(block)) FAIL() << *difference;
}

void expect_own_trees_of_chance(const Language& language, const std::set<std::string>& seeds) {
    test::TreeComparison comparison(language.blocks);
    RandomBlocks random(language, seeds);
    constexpr int rounds = 40'000;
    for (int i = 0; i < rounds && !::testing::Test::HasFatalFailure(); ++i) {
        std::set<std::string> blocks; // a byte of chance may end a block
        test::add_blocks(language.blocks, random.next(), blocks);
        expect_own_trees(comparison, blocks);
    }
}

void expect_own_trees(const Language& language, const std::set<std::string>& blocks) {
    test::TreeComparison comparison(language.blocks);
    expect_own_trees(comparison, blocks);
}

TEST(ParseCache, GivesFanucBlocksOfEveryKindTheirOwnTree) {
    expect_own_trees(fanuc_family, {"N2IF[#1EQ10]GOTO1",
                                    "X - [ #12 ] Y.5",
                                    "/2 G0 X1",
                                    "/0 G0 X1",
                                    "#101=#[#3+5]*2.5(TEXT 12 [])",
                                    "Z3./M14",
                                    "WHILE[#1LT5]DO1 (LOOP",
                                    "G65P9010A#1B-#[#2+1]",
                                    "DPRNT[X#100[53]*Y12]",
                                    "O1234(TITLE)",
                                    "O0 N0",
                                    "ZI#23 YI5",
                                    "IF #1EQ2 GOTO5",
                                    "#1=ATAN[#2]/[3]",
                                    "X#1/2",
                                    "SETVN 100[A1,B2]",
                                    "#_ABSKP[1]",
                                    "GO1 X1O5",
                                    "#<A(B>=1",
                                    "#<A(BC=1",
                                    "X1(A)Y2",
                                    "M98<PART 1>(CALL)",
                                    std::string("#1=1(A\0B)", 9),
                                    "#1=1(A B)"});
}

TEST(ParseCache, GivesDinPlusBlocksOfEveryKindTheirOwnTree) {
    expect_own_trees(din_plus, {"N15 G1 X-2.5 ID\"a1\" [note 7]", "[//]", "[ab]", "PRINT(\"open", "#l12=#_a1",
                                "#KEY \"A[B\"", "#KEY \"A-B\"", "#T\xC3\x84 \"A[B\"",
                                std::string("\xE2\x80\x9C") + "A[B\xE2\x80\x9D", "N1 // see \"a[b\"",
                                "G1 X5 (see \"a) X1 \"b", "G1 X5 (see \"a1 X1 \"b", "/159 N5 G0",
                                "IF #l1>5 [a \" b] \"c", "L\"sub\" LA5", "; 5\" [a] X1"});
}

TEST(ParseCache, GivesBlocksOfTheCorporaTheirOwnTree) {
    for (const Language* language : {&fanuc_family, &din_plus}) {
        const std::set<std::string> blocks = blocks_of_corpora(*language);
        ASSERT_GT(blocks.size(), 500U);
        expect_own_trees(*language, blocks);
    }
}

TEST(ParseCache, GivesRandomFanucBlocksTheirOwnTree) {
    expect_own_trees_of_chance(fanuc_family, blocks_of_corpora(fanuc_family));
}

TEST(ParseCache, GivesRandomDinPlusBlocksTheirOwnTree) {
    expect_own_trees_of_chance(din_plus, blocks_of_corpora(din_plus));
}

/// A NUL once ended the comment for the parser, and every block like it was wrong from then on.
TEST(ParseCache, ANulInACommentHarmsNeitherItsBlockNorALaterOne) {
    for (const std::string_view text : {"#1=5(A\0B)"sv, "#1=5(A-B)"sv})
        EXPECT_EQ(test::lower(text), "#1 := 5") << text;
    for (const std::string_view text : {"N1 #g1=5 [A\0B]"sv, "N1 #g1=5 [A-B]"sv})
        EXPECT_EQ(test::lower(test::read_as("dinplus", "a.ncs", text)), "N1 #g1 := 5") << text;
}

} // namespace
} // namespace maclint
