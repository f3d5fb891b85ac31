//! Says which cures are texts, and which of them are certain.
#include "rules/syntax_remedies.hpp"

#include "rules/fixes.hpp"

#include <optional>
#include <string>
#include <utility>

namespace maclint {
namespace {

/// Whether the cure is what to write in place of the text, word for word; nothing: it is a sentence, or what
/// is missing.
std::optional<Applicability> replacement_by_cure(SyntaxErrorKind kind) {
    switch (kind) {
    case SyntaxErrorKind::foreign_remark: // the control takes none of them for a remark
    case SyntaxErrorKind::blank_in_variable:
    case SyntaxErrorKind::hash_in_vacancy_test: return Applicability::safe;
    case SyntaxErrorKind::other_program_name:
    case SyntaxErrorKind::other_vacancy_test:
    case SyntaxErrorKind::section_of_other_language:
    case SyntaxErrorKind::unknown_internal_constant:
    case SyntaxErrorKind::unknown_keyword: return Applicability::unsafe; // something near was meant
    default: return std::nullopt;
    }
}

} // namespace

void offer_remedy(const ProgramFile& file, const SyntaxError& error, Finding& finding) {
    const Remedy& remedy = error.remedy;
    if (remedy.changes.empty()) {
        const auto applicability = replacement_by_cure(error.kind);
        if (applicability && !error.cure.empty() &&
            file.source->to_utf8(file.source->bytes(error.span)) == error.subject)
            rules::offer_text(finding, *applicability, error.span, error.cure);
        return;
    }
    Fix fix{std::string(remedy.title), remedy.certain ? Applicability::safe : Applicability::unsafe, {}};
    for (const TextChange& change : remedy.changes)
        fix.edits.push_back({file.source, change.span, std::string(change.text)});
    finding.offer(std::move(fix));
}

} // namespace maclint
