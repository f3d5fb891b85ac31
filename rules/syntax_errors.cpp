//! Turns syntax errors into findings.
#include "rules/syntax_errors.hpp"

#include "analyzer/program/faults.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/source/encoding.hpp"
#include "rules/syntax_remedies.hpp"

#include <algorithm>
#include <iterator>
#include <span>

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
    case SyntaxErrorKind::letter_in_jump:
    case SyntaxErrorKind::words_after_jump:
    case SyntaxErrorKind::condition_without_brackets:
    case SyntaxErrorKind::consequence_without_then:
    case SyntaxErrorKind::words_after_then:
    case SyntaxErrorKind::more_after_then:
    case SyntaxErrorKind::logic_outside_brackets:
    case SyntaxErrorKind::words_beside_statement:
    case SyntaxErrorKind::statement_beside_statement:
    case SyntaxErrorKind::jump_beside_statement:
    case SyntaxErrorKind::function_without_brackets:
    case SyntaxErrorKind::comparison_as_value:
    case SyntaxErrorKind::foreign_remark:
    case SyntaxErrorKind::remark_without_sign:
    case SyntaxErrorKind::missing_equals:
    case SyntaxErrorKind::late_definition:
    case SyntaxErrorKind::oversized_block: return "";
    case SyntaxErrorKind::foreign_keyword:
    case SyntaxErrorKind::bracket_mismatch: return error.cure;
    case SyntaxErrorKind::unreadable: return error.cure.empty() ? without_digits(error.subject) : error.cure;
    default: return in_capitals(error.subject);
    }
}

std::string_view message_for(const SyntaxError& error, const Reporter& reporter,
                             const SyntaxMessages& messages) {
    if (error.answer == Answer::stops_if_assumed && reporter.has_message(messages.elsewhere))
        return messages.elsewhere;
    if (error.answer == Answer::unknown && reporter.has_message(messages.unknown)) return messages.unknown;
    const bool cure = reporter.has_message(messages.with_cure) &&
                      (!error.cure.empty() || !reporter.has_message(messages.without));
    return cure ? messages.with_cure : messages.without;
}

bool is_told(const SyntaxError& error, std::span<const std::string_view> faults) {
    if (!faults.empty()) return std::ranges::find(faults, error.fault) != faults.end();
    return std::ranges::find(faults::told_by_own_rules, error.fault) == std::end(faults::told_by_own_rules) &&
           std::ranges::find(faults::of_real_time, error.fault) == std::end(faults::of_real_time);
}

} // namespace

std::string SyntaxCauses::of(const SyntaxError& error) {
    if (error.kind == SyntaxErrorKind::bare_remark) return error.cure; // whoever wrote the file writes so
    if (begins_.empty()) {
        for (const Program& program : file_.programs) begins_.push_back(program.span.begin);
        std::ranges::sort(begins_);
    }
    const auto begun = std::ranges::upper_bound(begins_, error.span.begin) - begins_.begin();
    return std::to_string(begun) + " " + std::to_string(static_cast<int>(error.kind)) + " " +
           reason_of(error);
}

void report_syntax_error(const ProgramFile& file, SyntaxErrorKind kind, Reporter& reporter,
                         const SyntaxMessages& messages) {
    SyntaxCauses causes(file);
    for (const SyntaxError& error : file.syntax_errors) {
        if (error.kind != kind || !is_told(error, messages.faults)) continue;
        if (messages.is_of_another != nullptr && messages.is_of_another(error)) continue;
        Finding& finding = reporter.report(
            {file, error.span}, error.span, message_for(error, reporter, messages),
            {to_utf8(error.subject, detect_encoding(error.subject)), error.cure, error.elsewhere});
        if (!error.fault.empty()) finding.alarm = reporter.alarm_for(file, error.fault);
        if (messages.severity) finding.severity = *messages.severity;
        if (error.answer == Answer::stops_if_assumed) finding.severity = Severity::warning;
        if (error.answer == Answer::unknown) finding.severity = Severity::note;
        if (finding.severity != Severity::error) finding.alarm = {};
        finding.same_cause = causes.of(error);
        offer_remedy(file, error, finding);
    }
}

} // namespace maclint
