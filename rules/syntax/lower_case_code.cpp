//! MAC104: code in small letters.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/number_limits.hpp"
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"
#include "rules/syntax/code_of_blocks.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule lower_case_code{
    .code = "MAC104",
    .name = "lower-case-code",
    .summary = "Words of the program are written in small letters",
    .why =
        "Manuals print addresses and keywords in capitals, and say nothing of small letters: a control may "
        "refuse the block.",
    .severity = Severity::note,
    .precision = Precision::medium,
    .on_by_default = false,
    .off_reason = "no document says what a control makes of small letters.",
    .messages = {{"plain", "Small letters: '{0}', the first of the file.", "Write '{1}'."}},
    .bad = {{"fanuc", R"nc(
O9104(PLATE)
G90 G0 X0
g1 x10. F100
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 g0 x60 z2
N11 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9104(PLATE, first side)
G90 G0 X0
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G0 X60 Z2
N11 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

std::size_t find_small(std::string_view code) {
    const auto* const small = std::ranges::find_if(code, [](char c) { return c >= 'a' && c <= 'z'; });
    return small == code.end() ? std::string_view::npos : static_cast<std::size_t>(small - code.begin());
}

/// Where the reader takes them without a word.
void check_code(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) {
        const std::optional<Offset> first = find_in_code(program, &find_small);
        if (!first) continue;
        Span word{*first, *first};
        while (word.end < program.text.size() && find_small(program.text.substr(word.end, 1)) == 0)
            ++word.end;
        reporter.report({file, word}, word, "plain",
                        {std::string(program.slice(word)), in_capitals(program.slice(word))});
        return;
    }
}

/// One for a file: whoever writes so writes all of it so.
void check(const ProgramFile& file, Reporter& reporter) {
    const auto first =
        std::ranges::find(file.syntax_errors, SyntaxErrorKind::small_letters, &SyntaxError::kind);
    if (first != file.syntax_errors.end())
        reporter.report({file, first->span}, first->span, "plain", {first->subject, first->cure});
    else if (number_limits(*file.control) != nullptr)
        check_code(file, reporter);
}

} // namespace
} // namespace maclint::rules
