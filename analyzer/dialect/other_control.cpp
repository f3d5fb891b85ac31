//! Looks only at what could not be read: a language shows by what it does not share.
#include "analyzer/dialect/other_control.hpp"

#include "analyzer/dialect/detect/first_program.hpp"
#include "analyzer/dialect/detect/line.hpp"
#include "analyzer/dialect/detect/signatures.hpp"
#include "analyzer/program/readable.hpp"
#include "analyzer/source/line_index.hpp"

#include <algorithm>
#include <array>

namespace maclint {
namespace {

using detect::Evidence;
using detect::Language;

/// The languages of controls that maclint does not know. What a PC reads is told by the whole text.
constexpr std::array unknown_controls{Language::klartext,      Language::heidenhain_iso, Language::sinumerik,
                                      Language::linuxcnc,      Language::wire_erosion,   Language::okuma,
                                      Language::lnc,           Language::syntec,         Language::fagor,
                                      Language::fadal,         Language::denford,        Language::traub,
                                      Language::several_paths, Language::acramatic,      Language::mazatrol};

constexpr std::size_t enough_marks = 2;
/// Five typing errors, twice: so many are no oversight.
constexpr std::size_t too_many = 10;
constexpr std::size_t share = 5; ///< one block in so many
constexpr std::size_t shown = 3;
constexpr std::size_t enough_remarks = 4;
/// How such a control formats what it writes into files: `G100 P221 (<FMT:.1F,#10>)`. Beside it two will do.
constexpr std::string_view format_of_output = "<FMT:";

/// Whether the text says nothing in the language: it is no word that is known elsewhere, no habit of writing
/// and no remark.
bool makes_no_sense(const SyntaxError& error) {
    switch (error.kind) {
    case SyntaxErrorKind::unknown_keyword: return error.cure.empty();
    case SyntaxErrorKind::unreadable: return true;
    default: return false;
    }
}

/// Whether the words in it are code: those of remarks may be any.
bool is_code(const SyntaxError& error) {
    return error.kind == SyntaxErrorKind::unknown_keyword || error.kind == SyntaxErrorKind::unreadable ||
           error.kind == SyntaxErrorKind::missing_construct || error.kind == SyntaxErrorKind::missing_value ||
           error.kind == SyntaxErrorKind::letter_o;
}

std::string_view line_at(std::string_view text, Offset place) {
    Offset begin = place;
    while (begin > 0 && !is_line_end(text[begin - 1])) --begin;
    return text.substr(begin, find_line_end(text, place) - begin);
}

/// Two different marks of one control; of two controls the one with more.
std::optional<OtherControl> control_by_marks(const ProgramFile& file,
                                             const std::vector<const SyntaxError*>& errors) {
    Evidence evidence{""};
    detect::Line line;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        line.read(line_at(file.source->bytes(), errors[i]->span.begin));
        if (!line.whole().empty()) evidence.add(line, i + 1); // its number is the place in `errors`
    }
    std::optional<OtherControl> best;
    for (const Language language : unknown_controls) {
        const std::vector<Evidence::Seen> seen = evidence.seen_in_code(language);
        if (seen.size() < enough_marks || (best && seen.size() <= best->marks.size())) continue;
        best = OtherControl{.name = detect::name_of(language), .marks = {}};
        for (const Evidence::Seen& mark : seen)
            best->marks.push_back({mark.called, errors[mark.line - 1]->span});
    }
    return best;
}

/// Where remarks after ';' are a habit, the control is one that has them.
std::optional<OtherControl> control_with_remarks(std::string_view text,
                                                 const std::vector<const SyntaxError*>& remarks) {
    const auto certain = static_cast<std::size_t>(std::ranges::count(
        remarks, SyntaxErrorKind::bare_remark, [](const auto* error) { return error->kind; }));
    if (certain < enough_marks) return std::nullopt;
    if (remarks.size() < enough_remarks && text.find(format_of_output) == std::string_view::npos)
        return std::nullopt;
    OtherControl found{.name = "a control that has remarks after ';'", .marks = {}};
    for (std::size_t i = 0; i < std::min(shown, remarks.size()); ++i)
        found.marks.push_back({"'" + remarks[i]->subject + "'", remarks[i]->span});
    return found;
}

/// What stands in ( ) after ';' was meant for a control that ends blocks so.
bool is_after_semicolon(std::string_view text, const SyntaxError& error) {
    const Offset end = error.span.begin + (error.kind == SyntaxErrorKind::bare_remark ? 1 : 0);
    const std::string_view before = text.substr(0, end);
    const std::size_t sign = before.find_last_of(";\r\n");
    if (sign == std::string_view::npos || text[sign] != ';') return false;
    const std::size_t remark = text.find_first_not_of("; \t", sign);
    return remark == std::string_view::npos || text[remark] != '(';
}

} // namespace

std::optional<OtherControl> find_other_control(const ProgramFile& file) {
    if (file.syntax_errors.size() < enough_marks) return std::nullopt; // as of most files, however long
    std::vector<const SyntaxError*> code;
    std::vector<const SyntaxError*> senseless;
    std::vector<const SyntaxError*> remarks;
    // Of a program at the head that is whole only its own text tells: what follows it may be line noise.
    const std::string_view text = file.source->bytes();
    const std::string_view head = detect::first_program(text);
    for (const SyntaxError& error : file.syntax_errors) {
        if (!head.empty() && error.span.begin >= head.size()) break;
        if (is_code(error)) code.push_back(&error);
        if (makes_no_sense(error)) senseless.push_back(&error);
        if ((is_code(error) || error.kind == SyntaxErrorKind::bare_remark) && is_after_semicolon(text, error))
            remarks.push_back(&error);
    }
    if (code.size() + remarks.size() < enough_marks) return std::nullopt;
    const Readable readable = count_readable(file);
    std::optional<OtherControl> found = control_by_marks(file, code);
    if (!found) found = control_with_remarks(text, remarks);
    if (!found && senseless.size() >= too_many && senseless.size() * share > readable.blocks) {
        found.emplace();
        for (std::size_t i = 0; i < shown; ++i)
            found->marks.push_back({"'" + senseless[i]->subject + "'", senseless[i]->span});
    }
    if (!found) return std::nullopt;
    found->unreadable = readable.unreadable;
    found->blocks = readable.blocks;
    std::ranges::sort(found->marks, {}, [](const OtherControl::Mark& mark) { return mark.place; });
    return found;
}

} // namespace maclint
