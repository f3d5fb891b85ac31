//! MAC583: a code that the language's manual does not have.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/lines_with.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/reporter.hpp"
#include "rules/rule.hpp"
#include "rules/words/code_pages.hpp"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <string_view>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unknown_code{
    .code = "MAC583",
    .name = "unknown-code",
    .summary = "A code stands in no chapter of the language's manual",
    .why = "A code that nobody describes is a typing error (G27 for G17), comes from another control, or "
           "belongs to the"
           " maker of the machine: on any other machine the control stops there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"unknown", "Unknown code {0}: the manual describes none of that number.",
                  "Correct it; if it is one of the machine's maker, allow it with a comment or in the "
                  "configuration."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G27 X5
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G26 S2000
END
)nc"}},
    .sources = {"SEED-003:9940-10160", "T: chapters of the manual are complete"},
    .check = &check,
};

namespace {

/// The whole G codes below a thousand that chapters have.
class KnownCodes {
  public:
    explicit KnownCodes(std::string_view language) {
        for (std::size_t code = 0; code < known_.size(); ++code)
            known_[code] = has_code_page(language, 'G', static_cast<double>(code));
    }

    /// Whether a number behind a G in the text may be no code's; words of comments count, too.
    [[nodiscard]] bool may_lack_one_of(std::string_view line) const {
        for (std::size_t i = line.find_first_of("Gg"); i < line.size(); i = line.find_first_of("Gg", i + 1)) {
            const std::size_t digits = std::min(line.find_first_not_of(' ', i + 1), line.size());
            if (digits < line.size() && is_digit(line[digits]) && !knows(line.substr(digits))) return true;
        }
        return false;
    }

  private:
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    [[nodiscard]] bool knows(std::string_view digits) const {
        std::size_t code = 0;
        std::size_t read = 0;
        for (; read < digits.size() && is_digit(digits[read]) && code < known_.size(); ++read)
            code = code * 10 + static_cast<std::size_t>(digits[read] - '0');
        const bool is_whole = read == digits.size() || digits[read] != '.';
        return is_whole && code < known_.size() && known_[code];
    }

    std::bitset<1000> known_;
};

void look_at(const ProgramAnalysis& analysis, std::span<const Word> words, Reporter& reporter) {
    for (const Word& word : words) {
        const auto* value = std::get_if<Literal>(&word.value);
        if (word.address != "G" || value == nullptr) continue;
        if (has_code_page(analysis.control().language, 'G', value->value)) continue;
        reporter.report({analysis, word.span}, word.span, "unknown", {quoted(analysis.program(), word.span)});
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const std::string_view language = analysis.control().language;
    if (!has_all_codes(language)) return;
    const KnownCodes known(language);
    const Slice all{0, static_cast<Id>(program.items.size())};
    for_each_block_with_words(
        program, all,
        [&](const PlainRun& run, const auto& take) {
            for_each_line_with("Gg", program.text, run.span, [&](Span line) {
                if (known.may_lack_one_of(program.text.substr(line.begin, line.length()))) take(line);
            });
        },
        [](const WordSummary&) { return true; },
        [&](const BlockView&, std::span<const Word> words, const WordSummary*) {
            look_at(analysis, words, reporter);
        });
}

} // namespace
} // namespace maclint::rules
