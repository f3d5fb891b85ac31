//! MAC115: a blank inside a number.
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/number_limits.hpp"
#include "rules/rule.hpp"
#include "rules/syntax/code_of_blocks.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule space_inside_number{
    .code = "MAC115",
    .name = "space-inside-number",
    .summary = "A blank stands inside a number",
    .why =
        "The control passes blanks over and reads one number: X1 0. is X10. Who reads the program sees two, "
        "and other controls stop.",
    .severity = Severity::warning,
    .precision = Precision::medium,
    .on_by_default = false,
    .off_reason = "lists of values beside a program are written so, too.",
    .messages = {{"plain", "Blank inside a number: '{0}', the first of the file.", "Write it without."}},
    .bad = {{"fanuc", R"nc(
O9115(PLATE)
G90 G0 X1 0. Y0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9115(PLATE)
G90 G0 X 10. Y0
/ 2 M0
M30
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

bool is_part_of_number(char c) { return is_digit(c) || c == '.'; }

/// The figure before the blank.
std::size_t find_blank(std::string_view code) {
    for (std::size_t at = code.find_first_of(" \t"); at != std::string_view::npos && at > 0;
         at = code.find_first_of(" \t", at + 1)) {
        const std::size_t next = code.find_first_not_of(" \t", at);
        if (next == std::string_view::npos) break;
        if (is_part_of_number(code[at - 1]) && is_part_of_number(code[next])) return at - 1;
    }
    return std::string_view::npos;
}

/// One for a file: whoever writes so writes all of it so.
void check(const ProgramFile& file, Reporter& reporter) {
    if (number_limits(*file.control) == nullptr) return;
    for (const Program& program : file.programs) {
        const std::optional<Offset> place = find_in_code(program, &find_blank);
        if (!place) continue;
        const std::string_view rest = program.text.substr(*place);
        const std::size_t next = rest.find_first_not_of(" \t", 1);
        const Span span{*place, *place + static_cast<Offset>(next + 1)};
        reporter.report({file, span}, span, "plain", {std::string(program.slice(span))});
        return;
    }
}

} // namespace
} // namespace maclint::rules
