//! Turns syntax errors into findings.
#include "rules/syntax_errors.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/source/encoding.hpp"

namespace maclint {

void report_syntax_error(const ProgramFile& file, SyntaxErrorKind kind, Reporter& reporter) {
    for (const SyntaxError& syntax_error : file.syntax_errors) {
        if (syntax_error.kind != kind) continue;
        const bool cure = !syntax_error.cure.empty() && reporter.has_message("cure");
        reporter.report(
            {file, syntax_error.span}, syntax_error.span, cure ? "cure" : "plain",
            {to_utf8(syntax_error.subject, detect_encoding(syntax_error.subject)), syntax_error.cure});
    }
}

} // namespace maclint
