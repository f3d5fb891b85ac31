//! Turns syntax errors into findings.
#include "rules/syntax_errors.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/source/encoding.hpp"

#include <algorithm>

namespace maclint {
namespace {

std::string without_digits(std::string text) {
    std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
    return text;
}

std::string in_capitals(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return text;
}

/// Why the text is wrong: who mends it in one place mends it in the same way in all of them.
std::string reason_of(const SyntaxError& error) {
    switch (error.kind) {
    case SyntaxErrorKind::missing_construct: // whatever word of it was written
    case SyntaxErrorKind::unterminated_comment:
    case SyntaxErrorKind::nested_comment:
    case SyntaxErrorKind::parenthesis_as_bracket:
    case SyntaxErrorKind::symbolic_comparison:
    case SyntaxErrorKind::oversized_block: return "";
    case SyntaxErrorKind::bracket_mismatch: return error.cure;
    case SyntaxErrorKind::unreadable: return error.cure.empty() ? without_digits(error.subject) : error.cure;
    default: return in_capitals(error.subject);
    }
}

} // namespace

std::string same_cause(const ProgramFile& file, const SyntaxError& error) {
    if (error.kind == SyntaxErrorKind::bare_remark) return error.cure; // whoever wrote the file writes so
    const auto begun = std::ranges::count_if(
        file.programs, [&](const Program& program) { return program.span.begin <= error.span.begin; });
    return std::to_string(begun) + " " + std::to_string(static_cast<int>(error.kind)) + " " +
           reason_of(error);
}

void report_syntax_error(const ProgramFile& file, SyntaxErrorKind kind, Reporter& reporter) {
    for (const SyntaxError& error : file.syntax_errors) {
        if (error.kind != kind) continue;
        const bool cure = !error.cure.empty() && reporter.has_message("cure");
        reporter
            .report({file, error.span}, error.span, cure ? "cure" : "plain",
                    {to_utf8(error.subject, detect_encoding(error.subject)), error.cure})
            .same_cause = same_cause(file, error);
    }
}

} // namespace maclint
