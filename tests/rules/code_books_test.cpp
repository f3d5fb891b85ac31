//! What chapters of codes find in programs: conditions, neighbours, sections, words and codes that nobody
//! lists.
#include "rules/words/book_language.hpp"
#include "rules/words/code_book.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/word_list.hpp"
#include "tests/support/linted.hpp"

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr std::string_view of_chapters[] = {"MAC523", "MAC527", "MAC575", "MAC576", "MAC577", "MAC578",
                                            "MAC579", "MAC580", "MAC581", "MAC582", "MAC123"};

/// What the rules on codes find in a file, with its lines: "MAC576/G14.Q 2", "MAC123 3".
std::vector<std::string> found_in_file(const std::string& name, const std::string& text) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect("dinplus");
    for (const std::string_view code : of_chapters) overrides.select.emplace_back(code);
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : lint_texts({{name, text}}, std::move(overrides)).findings) {
        const std::string rule =
            finding.row == nullptr ? std::string(finding.rule->code) : finding.row->name();
        all.push_back(rule + " " + std::to_string(finding.source->position(finding.span.begin).line));
    }
    return all;
}
std::vector<std::string> machining(const std::string& blocks) {
    return found_in_file("part.nc", "MACHINING\n" + blocks + "END\n");
}
std::vector<std::string> contour(const std::string& section, const std::string& blocks) {
    return found_in_file("part.nc", section + "\n" + blocks + "MACHINING\nEND\n");
}

TEST(Conditions, HoldForTheValuesThatAreWritten) {
    EXPECT_THAT(machining("N1 G16 Q1 I5\n"), ElementsAre("MAC523/G16.B-Q1 2"));
    EXPECT_THAT(machining("N1 G16 Q1 B30\nN2 G16 Q0\nN3 G16 Q#l1\n"), IsEmpty());
}

TEST(Conditions, MayHoldForAWordThatIsMissing) {
    EXPECT_THAT(machining("N1 G102 XK5 YK5 I1 K2\n"), ElementsAre("MAC579/G102.K-H01-NOR 2"));
    EXPECT_THAT(machining("N1 G102 XK5 YK5 H2 I1 K2\nN2 G102 XK5 YK5 H#l1 I1 K2\n"), IsEmpty());
}

TEST(Partners, CountWithOneOfTheirValues) {
    EXPECT_THAT(machining("N1 G41 Q0 H1\nN2 G1 X5\n"), ElementsAre("MAC577/G41.H-Q1234-H1 2"));
    EXPECT_THAT(machining("N1 G41 Q2 H1\nN2 G1 X5\nN3 G40\nN4 G42 Q#l1 H1\nN5 G1 X9\n"), IsEmpty());
}

TEST(BlocksBefore, SayWhetherARowHolds) {
    const std::string pattern = "N1 G308 ID\"A\" P-5\nN2 G402 Q4 K60 A0 Wi90 XK0 YK0\n";
    EXPECT_THAT(contour("FACE_C Z0", pattern + "N3 G300 XK5 B8 P10\nN4 G309\n"),
                ElementsAre(testing::StartsWith("MAC579/G300.")));
    EXPECT_THAT(contour("FACE_C Z0", pattern + "N3 G300 B8 P10\nN4 G300 XK5 YK5 B8 P10\nN5 G309\n"),
                IsEmpty())
        << "the second one follows a hole";
}

TEST(BlocksAfter, AreSearchedForSomeTwoHundredLines) {
    const auto moves = [](int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += "G1 X50 Z-5\n";
        return text;
    };
    EXPECT_THAT(machining("G58 P-0.5\n" + moves(150) + "G890 NS3 NE5\n"), IsEmpty());
    EXPECT_THAT(machining("G58 P-0.5\n" + moves(150) + "G891 NS3 NE5\n"), IsEmpty())
        << "the second of the list";
    EXPECT_THAT(machining("G58 P-0.5\n" + moves(250) + "G890 NS3 NE5\n"), ElementsAre("MAC576/G58.P 2"));
}

TEST(BlocksAfter, MayDescribeTheContour) {
    EXPECT_THAT(machining("N1 G810 P2\nN2 M30\n"), ElementsAre("MAC523/G810.ID+NS 2"));
    EXPECT_THAT(machining("N1 G810 P2\nN2 G0 X50 Z0\nN3 G1 Z-20\nN4 G80\n"), IsEmpty());
    EXPECT_THAT(machining("N1 G810 P2\nN2 #l1=40\nN3 G0 X#l1 Z0\nN4 G1 Z-20\nN5 G80\n"), IsEmpty());
    EXPECT_THAT(machining("N1 G810 P2\nN2 L\"MUOTO\" V1\n"), IsEmpty()) << "the call may describe it";
}

TEST(Places, OfContoursAreNoneInMachiningUnlessOneIsDescribedThere) {
    EXPECT_THAT(machining("N1 G22 X30 Z-20\n"), ElementsAre("MAC527/G22 2"));
    EXPECT_THAT(machining("N1 G860\nN2 G0 X50 Z0\nN3 G1 Z-40\nN4 G22 X40 Z-20 I45 K-10\nN5 G80\n"),
                IsEmpty());
    EXPECT_THAT(machining("N1 G20 X50 Z60 K1\nN2 G80\n"), ElementsAre("MAC527/G20 2")) << "a blank is none";
}

TEST(Places, OfMachiningAreNoneInContours) {
    EXPECT_THAT(contour("FINISHED", "N1 G0 X0 Z0\nN2 G1 X40\nN3 G14 Q0\nN4 M8\n"),
                UnorderedElementsAre("MAC527/G14 4", "MAC527/M8 5"));
    EXPECT_THAT(found_in_file("part.nc", "FINISHED\nN1 G0 X0 Z0\nN2 G14 Q0\nEND\n"), IsEmpty())
        << "MACHINING is missing, which another rule tells";
}

TEST(Places, AreUnknownWithoutSectionsButInSubprograms) {
    const std::string text = "N1 G20 X50 Z60 K1\nN2 G14 Q9\n";
    EXPECT_THAT(found_in_file("snippet.nc", text), ElementsAre("MAC576/G14.Q 2"));
    EXPECT_THAT(found_in_file("sub.ncs", "%sub.ncs\n" + text + "RETURN\n"), ElementsAre("MAC576/G14.Q 3"))
        << "it may describe a contour";
}

TEST(WordsThatNobodyLists, AreThoseOfNoCodeOfTheBlock) {
    EXPECT_THAT(machining("N1 G14 Q0 H2\n"), ElementsAre("MAC581/G14 2"));
    EXPECT_THAT(machining("N1 G14 Q0 F2 S100 T1 M8\n"), IsEmpty()) << "they go with any code";
    EXPECT_THAT(machining("N1 G1 X5 G14 Q0 Z3\n"), IsEmpty()) << "Z is of G1";
    EXPECT_THAT(machining("N1 G14 H2 M70\n"), IsEmpty()) << "nobody knows what M70 takes";
    EXPECT_THAT(machining("N1 G1 X50\nN2 X60 G95 F0.2\nN3 Z-5 M8\nN4 X82 G40\nN5 G4 F1 X50\nN6 X60 BR2 G9\n"),
                IsEmpty())
        << "the move goes on";
    EXPECT_THAT(contour("FINISHED", "N1 G0 X0 Z0\nN2 G1 Z-60\nN3 X82 G52 P0.2\nN4 G1 X90 V3\n"),
                ElementsAre("MAC581/G1 5"));
}

TEST(WordsThatNobodyLists, AreFoundAmongPlainBlocks) {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += "G1 X50 Z-5\nG0 X60 M8\n";
    EXPECT_THAT(machining(text + "G14 Q0 W2\n" + text), ElementsAre("MAC581/G14 6002"));
}

TEST(WordsThatNobodyLists, WithALetterOForAZeroAreToldOnce) {
    for (const std::string text :
         {"MACHINING\nN1 G785 R1 JO\nEND\n", "CHUCKING EQUIPMENT 1\nHO D0 Q4\nMACHINING\nN1 M30\nEND\n"}) {
        cli::Overrides overrides;
        overrides.dialect = find_dialect("dinplus");
        overrides.select = {"MAC106", "MAC581", "DIN109"};
        EXPECT_THAT(codes(lint_texts({{"part.nc", text}}, std::move(overrides))), ElementsAre("MAC106"))
            << text;
    }
}

TEST(UnknownCodes, AreThoseOfNoChapter) {
    EXPECT_THAT(machining("N1 G27 X5\nN2 G1 X#l1 G1234\nN3 G 27\n"),
                ElementsAre("MAC123 2", "MAC123 3", "MAC123 4"));
    EXPECT_THAT(machining("N1 G1 X5 [G27 before]\nN2 G0 X60\nN3 M777\n"), IsEmpty());
}

TEST(UnknownCodes, AreNotSearchedWhereNoChapterIs) {
    EXPECT_THAT(codes(lint_text("O1\nG441 X5.\nM30\n")), testing::Not(testing::Contains("MAC123")));
}

TEST(Chapters, HaveEachWordOfACodeOnce) {
    for (const CodePage& page : all_code_pages()) {
        std::set<std::string_view> words;
        for (const BookLine& line : page.lines) {
            if (line.kind != BookLine::Kind::word) continue;
            EXPECT_TRUE(words.insert(line.row.words).second)
                << page.head->row.code.view() << " has " << line.row.words.view() << " twice";
            EXPECT_FALSE(line.row.means.empty())
                << page.head->row.code.view() << " " << line.row.words.view();
            EXPECT_TRUE(line.line != 0U || !line.source.empty());
        }
    }
}

/// A statement names words that the code takes, and codes that there are.
TEST(Chapters, NameWordsAndCodesThatThereAre) {
    for (const CodePage& page : all_code_pages()) {
        std::set<std::string_view> words;
        for (const BookLine& line : page.lines)
            if (line.kind == BookLine::Kind::word)
                for (const std::string_view word : words_of(line.row.words)) words.insert(word);
        const std::string_view of_any = book_language(page.book->language).any_code_takes;
        for (const BookLine& line : page.lines) {
            if (line.kind != BookLine::Kind::statement || line.row.says == RowStatement::precedes) continue;
            for (const std::string_view word :
                 words_of(line.row.words)) // those of a move may be needed beside it
                EXPECT_TRUE(words.contains(word) || line.row.says == RowStatement::needs ||
                            line.row.says == RowStatement::takes_not || has_word(of_any, word) ||
                            line.row.says == RowStatement::until)
                    << page.head->row.code.view() << " takes no " << word;
            for (const std::string_view codes : {line.row.after, line.row.unless_after, line.row.unless_next})
                for (const std::string_view code : words_of(codes))
                    EXPECT_FALSE(pages_of_code(page.book->language, code).empty()) << code;
        }
    }
}

TEST(Chapters, HaveOnePageOfACodeInASection) {
    std::set<std::string> known;
    for (const CodePage& page : all_code_pages())
        for (const std::string_view code : words_of(page.head->row.code))
            for (const std::string_view section : words_of(page.sections()))
                EXPECT_TRUE(
                    known.insert(std::string(page.book->language) + std::string(code) + std::string(section))
                        .second)
                    << code << " twice in " << section;
}

} // namespace
} // namespace maclint::test
