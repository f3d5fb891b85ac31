//! DIN109: a word beside the name of a section, or in its description, that the section does not take.
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/section_pages.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule section_parameter{
    .code = "DIN109",
    .name = "section-parameter",
    .summary = "A word of a section's description is none that the section takes, has a value that it does "
               "not take, or"
               " is missing",
    .why = "The words beside the name of a section say where its contours lie, those below what is clamped "
           "and which"
           " tools there are: a wrong one puts the contour elsewhere, or another tool is called.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"unlisted", "Word '{0}' of {1}, which does not take it: the manual lists no such word.",
                  "Remove '{0}', or correct its address."},
                 {"value", "Value '{0}' of {1}, which takes {2} of {3}: the manual knows no other.",
                  "Write {2} of {3}."},
                 {"missing", "Word missing beside '{0}' of {1}: {2}. Without it {3}.", "Write {2}."}},
    .bad = {{"dinplus", R"nc(
PROGRAM HEAD
CONTOUR Q1 X0 Z0 V1
BLANK
N1 G20 X50 Z80 K1
MACHINING
N2 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
PROGRAM HEAD
CONTOUR Q1 X0 Z0 V2
BLANK
N1 G20 X50 Z80 K1
MACHINING
N2 M30
END
)nc"}},
    .sources = {"SEED-003:2756-2907"},
    .check = &check,
};

namespace {

/// Holds words against the page of their section.
class Held {
  public:
    Held(const ProgramAnalysis& analysis, const SectionPage& page, Reporter& reporter)
        : analysis_(analysis)
        , page_(page)
        , reporter_(reporter) {}

    void look_at(std::span<const Word> words) {
        for (const Word& word : words) {
            if (!word.has_value()) continue; // MAC109 speaks of that, or MAC106 of its letter O
            const BookLine* line = page_.find(word.address);
            if (line == nullptr)
                report(word, "unlisted", {text_of(word), page_.name});
            else if (const auto* value = std::get_if<Literal>(&word.value);
                     value != nullptr && !takes(line->row, value->value))
                report(word, "value",
                       {text_of(word), page_.name, std::string(word.address), values_allowed_by(line->row)});
        }
    }

    /// Of a line that names one of several: the first word of the page.
    void look_for_missing(std::span<const Word> words) {
        const auto first = std::ranges::find(words, page_.lines.front().row.words, &Word::address);
        if (first == words.end()) return;
        for (const BookLine& line : page_.lines)
            if (line.need == Need::likely &&
                std::ranges::find(words, line.row.words, &Word::address) == words.end())
                report(*first, "missing",
                       {text_of(*first), page_.name, words_with_meaning(line.row),
                        std::string(line.row.effect)});
    }

  private:
    [[nodiscard]] std::string text_of(const Word& word) const {
        return quoted(analysis_.program(), word.span);
    }
    void report(const Word& word, std::string_view message, std::vector<std::string> arguments) {
        reporter_.report({analysis_, word.span}, word.span, message, std::move(arguments));
    }

    const ProgramAnalysis& analysis_;
    const SectionPage& page_;
    Reporter& reporter_;
};

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const Section& section : program.sections) {
        const auto page = page_of_section(analysis.control(), section);
        if (!page) continue;
        Held held(analysis, *page, reporter);
        held.look_at(queries::heading_words(program, section));
        if (!page->describes_by_blocks) continue;
        for (ItemId item = section.items.first; item < section.items.first + section.items.count; ++item)
            for_each_block_with_words(program, Stretch{item, program.span_of(item)},
                                      [&](const BlockView&, std::span<const Word> words) {
                                          held.look_at(words);
                                          held.look_for_missing(words);
                                      });
    }
}

} // namespace
} // namespace maclint::rules
