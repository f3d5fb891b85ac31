//! Tells which dialect a file is written in, or what it is instead, by its extension and the beginning of its
//! text.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/detect/control_marks.hpp"
#include "analyzer/dialect/detect/first_program.hpp"
#include "analyzer/dialect/detect/line.hpp"
#include "analyzer/dialect/detect/line_kinds.hpp"
#include "analyzer/dialect/detect/other_text.hpp"
#include "analyzer/dialect/detect/signatures.hpp"
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/content.hpp"
#include "analyzer/source/line_index.hpp"

#include <algorithm>

namespace maclint {
namespace {

using detect::Evidence;
using detect::Language;
using detect::Line;

constexpr std::size_t looked_at = 64 * 1024;

/// The extension in small letters without its point.
std::string extension_of(std::string_view path) {
    const std::string_view name = file_name_of(path);
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return {};
    std::string extension(name.substr(dot + 1));
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension;
}

/// `%O9601(NAME)`: NCT puts mark and number on one line; others do so at times.
bool has_nct_head(std::string_view first) {
    return first.size() > 2 && first[0] == '%' && first[1] == 'O' && is_digit(first[2]);
}

/// `ZI#23`, `COS#150`: only NCT writes so.
bool has_nct_form(std::string_view code) {
    constexpr std::string_view axes = "XYZUVWABCR";
    for (std::size_t at = code.find('I'); at != std::string_view::npos; at = code.find('I', at + 1)) {
        if (at == 0 || at + 1 == code.size() || axes.find(code[at - 1]) == std::string_view::npos) continue;
        if (at >= 2 && is_capital(code[at - 2])) continue;
        if (code[at + 1] == '#' || code[at + 1] == '[' || code[at + 1] == '-') return true;
    }
    static constexpr std::string_view calls[] = {"COS#", "SIN#", "ABS#", "COS #", "SIN #", "ABS #"};
    return std::ranges::any_of(
        calls, [&](std::string_view call) { return code.find(call) != std::string_view::npos; });
}

/// What the beginning of a text holds.
struct Survey {
    Evidence evidence;
    detect::ControlEvidence controls = {};
    detect::LineCounts lines = {};
    std::size_t filled = 0, blocks = 0; ///< lines
    bool nct_head = false;
    std::size_t nct_line = 0; ///< after such a head, with the first form of NCT, or 0

    [[nodiscard]] bool is_nc_text() const { return blocks * 3 >= filled && lines.is_program_text(); }
};

Survey survey(std::string_view text, std::string_view extension) {
    Survey result{Evidence(extension)};
    Line line;
    std::size_t number = 1;
    detect::LineEnds ends(text);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = ends.from(at);
        line.read(text.substr(at, end - at));
        if (!line.whole().empty()) {
            if (++result.filled == 1) result.nct_head = has_nct_head(line.whole());
            result.blocks += detect::looks_like_block(line.whole()) ? 1U : 0U;
            result.evidence.add(line, number);
            result.controls.add(line, number);
            result.lines.add(line);
            if (result.nct_head && result.nct_line == 0 && has_nct_form(line.code()))
                result.nct_line = number;
        }
        at = end == text.size() ? end : after_line_end(text, static_cast<Offset>(end));
        ++number;
    }
    return result;
}

Detection foreign(const Evidence& evidence, Language language) {
    return {nullptr, std::string(detect::name_of(language)) + " (" + evidence.reason(language) + ")", false,
            true};
}

/// " (PNG image)", or nothing.
std::string kind_in_brackets(std::string_view bytes) {
    const auto kind = detect::find_binary_kind(bytes);
    return kind ? " (" + std::string(*kind) + ")" : std::string();
}

/// Whether rows of data make a file one of data.
enum class Data : std::uint8_t { may_be, is_none };

/// Programs begin after the data of a memory dump at times.
bool holds_program_number(std::string_view text) {
    for (std::size_t at = text.find("\nO"); at != std::string_view::npos; at = text.find("\nO", at + 1))
        if (at + 2 < text.size() && is_digit(text[at + 2])) return true;
    return false;
}

constexpr std::string_view data_head = "data, no program";

Detection judge(Content content, std::string_view text, const std::string& extension, Data data) {
    const Dialect* fanuc = find_dialect("fanuc");
    switch (content) {
    case Content::empty: text = {}; break; // the extension may tell
    case Content::utf16: return {nullptr, "UTF-16 text, which no control reads", true, true};
    case Content::binary: return {nullptr, "a binary file" + kind_in_brackets(text), true, true};
    case Content::text: break;
    }
    if (const auto other = detect::find_other_text(text)) return {nullptr, std::string(*other), true, true};

    const Survey found = survey(text, extension);
    const Language language = found.evidence.verdict();
    const bool certain = found.evidence.points(language) >= detect::enough;
    const bool shared_marks = language == Language::fanuc || language == Language::hobby;
    if (shared_marks && !found.is_nc_text())
        return {nullptr, "text of another kind (few lines look like blocks)", true, true};
    if (language == Language::fanuc && data == Data::may_be)
        if (const auto kind = found.lines.data())
            return {nullptr, std::string(data_head).append(" (").append(*kind).append(")"), false, true};
    if (language == Language::din_plus && !detect::reads_as_din_plus(text))
        return {nullptr, "text of another kind (few lines look like blocks)", true, true};
    if (language == Language::din_plus)
        return {find_dialect("dinplus"), found.evidence.reason(language), false, certain};
    if (language == Language::sinumerik)
        return {find_dialect("sinumerik"), found.evidence.reason(language), false, certain};
    if (language != Language::fanuc) return foreign(found.evidence, language);
    if (found.nct_line != 0)
        return {find_dialect("nct"), "an NCT form on line " + std::to_string(found.nct_line), false, certain};
    Detection detected{
        fanuc, extension.empty() ? std::string("content") : "extension ." + extension + " and content", false,
        certain};
    detected.control = found.controls.verdict();
    if (!detected.control.empty()) detected.control_reason = found.controls.reason();
    return detected;
}

// Extensions that are worth opening, if only to say that the file is not linted. Files without one are when
// they are named like a program: O9100.
constexpr std::string_view extensions[] = {"nc",  "ncc", "ncf", "cnc", "tap", "ngc", "gcode", "gc",  "g",
                                           "eia", "iso", "pim", "min", "fan", "nct", "mac",   "prg", "pgm",
                                           "sub", "txt", "ncs", "mpf", "spf", "h",   "din",   "dnc", "anc",
                                           "hnc", "gcd", "ssb", "msb", "ptp", "ncd", "cpf",   "arc", "def"};

/// O9100, and with words behind the number: O9010_TORUS.
bool is_program_name(std::string_view name) {
    if (name.size() < 2 || to_capital(name[0]) != 'O' || !is_digit(name[1])) return false;
    const std::size_t end = std::min(name.find_first_not_of("0123456789", 1), name.size());
    return end == name.size() || std::string_view("_- (").find(name[end]) != std::string_view::npos;
}

/// 1234, nc40: programs that other files may be named like, too.
bool is_number_name(std::string_view name) {
    constexpr std::size_t most_digits = 8;
    if (name.size() > 2 && to_capital(name[0]) == 'N' && to_capital(name[1]) == 'C') name.remove_prefix(2);
    return !name.empty() && name.size() <= most_digits && std::ranges::all_of(name, is_digit);
}

} // namespace

Detection detect_dialect(const Source& source) {
    const std::string extension = extension_of(source.path());
    const std::string_view bytes = source.bytes();
    const std::string_view text = bytes.substr(byte_order_mark_length(bytes), looked_at);
    Detection whole = judge(classify(bytes), text, extension, Data::may_be);
    if (whole.reason.starts_with(data_head) &&
        (is_program_name(file_name_of(source.path())) || holds_program_number(bytes.substr(text.size()))))
        whole = judge(classify(bytes), text, extension, Data::is_none);
    if (whole.certain && whole.dialect != nullptr) return whole;
    // What line noise after a good program looks like is chance.
    const std::string_view first = detect::first_program(text);
    if (first.empty() || first.size() == text.size()) return whole;
    Detection head = judge(Content::text, first, extension, Data::is_none);
    if (head.dialect == nullptr) return whole;
    head.certain = true;
    head.control = whole.control;
    head.control_reason = std::move(whole.control_reason);
    return head;
}

bool is_plainly_a_program(std::string_view beginning) {
    const Detection detection = judge(classify(beginning), beginning, {}, Data::may_be);
    if (detection.dialect == nullptr || is_empty(beginning)) return false;
    if (detection.certain) return true;
    constexpr std::size_t enough_blocks = 2;
    const std::size_t first = beginning.find_first_not_of(std::string_view(" \t\r\n\0", 5));
    return beginning[first] == '%' && survey(beginning, {}).lines.blocks() >= enough_blocks;
}

bool has_nc_extension(std::string_view path) {
    const std::string extension = extension_of(path);
    const std::string_view name = file_name_of(path);
    if (extension.empty()) return is_program_name(name) || is_number_name(name);
    return std::ranges::find(extensions, extension) != std::end(extensions);
}

bool is_worth_a_note(std::string_view path) {
    const std::string extension = extension_of(path);
    if (extension.empty()) return !is_number_name(file_name_of(path));
    return extension != "txt" && extension != "h" && extension != "def";
}

} // namespace maclint
