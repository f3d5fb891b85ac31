//! Tells which dialect a file is written in, or what it is instead, by its extension and the beginning of its
//! text.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/content.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace maclint {
namespace {

constexpr std::size_t looked_at = 64 * 1024;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\0'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view trim(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string in_capitals(std::string_view text) {
    std::string capitals(text);
    std::ranges::transform(capitals, capitals.begin(), upper);
    return capitals;
}

/// The extension in small letters without its point.
std::string extension_of(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return {};
    std::string extension(name.substr(dot + 1));
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension;
}

bool starts_with_any(std::string_view text, std::span<const std::string_view> heads) {
    return std::ranges::any_of(heads, [&](std::string_view head) { return text.starts_with(head); });
}

bool holds_any(std::string_view text, std::span<const std::string_view> parts) {
    return std::ranges::any_of(
        parts, [&](std::string_view part) { return text.find(part) != std::string_view::npos; });
}

/// Behind a sequence number `N10` or Klartext's bare line number.
std::string_view behind_number(std::string_view line) {
    std::string_view rest = line;
    if (!rest.empty() && rest.front() == 'N') rest.remove_prefix(1);
    std::size_t digits = 0;
    while (digits < rest.size() && is_digit(rest[digits])) ++digits;
    return digits == 0 ? line : trim(rest.substr(digits));
}

// ---- one line of each language; lines come in capitals and trimmed ----

bool is_klartext(std::string_view line) {
    static constexpr std::string_view heads[] = {"BEGIN PGM", "END PGM",  "TOOL CALL", "TOOL DEF",
                                                 "CYCL DEF",  "BLK FORM", "CALL LBL",  "LBL ",
                                                 "FN 0:",     "FN0:",     "CYCL CALL"};
    return starts_with_any(behind_number(line), heads);
}

bool is_din_plus(std::string_view line) {
    static constexpr std::string_view sections[] = {"PROGRAM HEAD", "PROGRAMMKOPF", "MACHINING",
                                                    "BEARBEITUNG", "#UNIT"};
    return starts_with_any(line, sections);
}

/// `R10=`, with or without something before it.
bool assigns_r_parameter(std::string_view line) {
    for (std::size_t at = line.find('R'); at != std::string_view::npos; at = line.find('R', at + 1)) {
        if (at > 0 && (is_letter(line[at - 1]) || line[at - 1] == '_')) continue;
        std::size_t end = at + 1;
        while (end < line.size() && is_digit(line[end])) ++end;
        if (end == at + 1) continue;
        while (end < line.size() && is_blank(line[end])) ++end;
        if (end < line.size() && line[end] == '=') return true;
    }
    return false;
}

/// What only Siemens writes; `%_N_` and `;$PATH` are written by the control itself.
int siemens_signs(std::string_view line) {
    static constexpr std::string_view certain[] = {"%_N_", ";$PATH=", "; $PATH="};
    if (starts_with_any(line, certain)) return 4;
    const std::string_view code = behind_number(line.substr(0, line.find(';')));
    static constexpr std::string_view heads[] = {
        "DEF REAL", "DEF INT", "DEF STRING", "DEF BOOL",   "DEF AXIS", "DEF CHAR", "DEF FRAME",
        "PROC ",    "EXTERN ", "MSG(",       "WORKPIECE(", "STOPRE",   "ENDPROC",  "MSG (",
        "GOTOF ",   "GOTOB ",  "REPEATB ",   "ENDFOR",     "SETMS"};
    static constexpr std::string_view parts[] = {"CYCLE8", "CYCLE9", " GOTOF ", " GOTOB ", "$P_",  "$AA_",
                                                 "$A_",    "$TC_",   "$MC_",    "$MN_",    "T=\"", "D0 M17"};
    int signs = 0;
    if (starts_with_any(code, heads)) signs += 2;
    if (holds_any(code, parts)) signs += 1;
    if (assigns_r_parameter(code)) signs += 1;
    return signs;
}

/// `o100 sub`, `o<name> call`, `o[#1] if`.
bool is_o_word(std::string_view line) {
    if (line.size() < 3 || line.front() != 'O') return false;
    std::size_t at = 1;
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at == line.size()) return false;
    if (line[at] == '<' || line[at] == '[') {
        at = line.find(line[at] == '<' ? '>' : ']', at);
        if (at == std::string_view::npos) return false;
        ++at;
    } else {
        const std::size_t digits = at;
        while (at < line.size() && is_digit(line[at])) ++at;
        if (at == digits) return false;
    }
    static constexpr std::string_view words[] = {"SUB",    "ENDSUB",    "CALL",     "IF",      "ELSE",
                                                 "ENDIF",  "WHILE",     "ENDWHILE", "DO",      "REPEAT",
                                                 "RETURN", "ENDREPEAT", "BREAK",    "CONTINUE"};
    return starts_with_any(trim(line.substr(at)), words);
}

/// A block that a control of the Fanuc family could hold: a word, a variable, a keyword, a comment, a tape
/// mark.
bool is_block(std::string_view line) {
    while (!line.empty() && (line.front() == '/' || line.front() == ' ')) line.remove_prefix(1);
    if (line.empty()) return true;
    const char first = line.front();
    if (first == '(' || first == '%' || first == ';' || first == ':' || first == '<') return true;
    const std::string_view code = behind_number(line);
    if (code.empty() || code.front() == '#' || code.front() == '(' || code.front() == '/' ||
        code.front() == ';')
        return true;
    static constexpr std::string_view keywords[] = {"IF[",   "IF [",  "WHILE", "GOTO",  "END",  "DO",
                                                    "POPEN", "PCLOS", "DPRNT", "BPRNT", "SETVN"};
    if (starts_with_any(code, keywords)) return true;
    if (!is_letter(code.front())) return false;
    std::size_t value = 1;
    while (value < code.size() && is_blank(code[value])) ++value;
    if (value == code.size()) return code.size() == 1;
    constexpr std::string_view values = "0123456789+-.#[<";
    return values.find(code[value]) != std::string_view::npos;
}

// ---- other kinds of text ----

std::optional<std::string> other_text(std::string_view text) {
    const std::string_view head = trim(text.substr(0, text.find_first_of("\r\n")));
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return std::nullopt;
    const std::string_view begin = text.substr(first);
    if (begin.front() == '{' ||
        (begin.front() == '[' && begin.size() > 1 && (begin.find_first_of("{\"") < 20)))
        return "JSON";
    if (begin.starts_with("<?xml") || begin.starts_with("<!DOCTYPE") || begin.starts_with("<html"))
        return "XML or HTML";
    if (head.starts_with("#!")) return "a script";
    static constexpr std::string_view c_lines[] = {"#include", "#define",  "#ifndef",    "#ifdef", "#pragma",
                                                   "int main", "typedef ", "namespace ", "/*"};
    std::size_t c_signs = 0;
    std::size_t lines = 0;
    for (std::size_t at = first; at < text.size() && lines < 200; ++lines) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const std::string_view line = trim(text.substr(at, end - at));
        if (starts_with_any(line, c_lines) || line.ends_with("{")) ++c_signs;
        at = end + 1;
    }
    if (c_signs >= 2) return "C source";
    return std::nullopt;
}

/// `%O9601(NAME)`: NCT puts mark and number on one line; others do so at times.
bool has_nct_head(std::string_view first) {
    return first.size() > 2 && first[0] == '%' && first[1] == 'O' && is_digit(first[2]);
}

/// `ZI#23`, `COS#150`: only NCT writes so.
bool has_nct_form(std::string_view line) {
    constexpr std::string_view axes = "XYZUVWABCR";
    for (std::size_t at = line.find('I'); at != std::string_view::npos; at = line.find('I', at + 1)) {
        if (at == 0 || at + 1 == line.size() || axes.find(line[at - 1]) == std::string_view::npos) continue;
        if (at >= 2 && is_letter(line[at - 2])) continue;
        if (line[at + 1] == '#' || line[at + 1] == '[' || line[at + 1] == '-') return true;
    }
    static constexpr std::string_view calls[] = {"COS#", "SIN#", "ABS#", "COS #", "SIN #", "ABS #"};
    return holds_any(line, calls);
}

/// What the lines of a text count up to.
struct Lines {
    std::size_t filled = 0, blocks = 0, klartext = 0, din_plus = 0, siemens = 0, o_words = 0, nct = 0;
    std::size_t remarks = 0, remark_line = 0; ///< `//`, as wire-erosion controls write them
    std::size_t klartext_line = 0, din_plus_line = 0, siemens_line = 0, o_word_line = 0, nct_line = 0;
    std::string first; ///< first line with text
};

void note(std::size_t signs, std::size_t line, std::size_t& count, std::size_t& first_line) {
    if (signs == 0) return;
    if (count == 0) first_line = line;
    count += signs;
}

Lines count_lines(std::string_view text) {
    Lines lines;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        ++number;
        while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        const std::string capitals = in_capitals(trim(line));
        if (capitals.empty()) continue;
        if (++lines.filled == 1) lines.first = capitals;
        lines.blocks += is_block(capitals) ? 1 : 0;
        note(is_klartext(capitals) ? 1 : 0, number, lines.klartext, lines.klartext_line);
        note(capitals.starts_with("//") ? 1 : 0, number, lines.remarks, lines.remark_line);
        note(is_din_plus(capitals) ? 1 : 0, number, lines.din_plus, lines.din_plus_line);
        note(static_cast<std::size_t>(siemens_signs(capitals)), number, lines.siemens, lines.siemens_line);
        note(is_o_word(capitals) || capitals.find("#<") != std::string::npos ? 1 : 0, number, lines.o_words,
             lines.o_word_line);
        note(has_nct_form(capitals.substr(0, capitals.find('('))) ? 1 : 0, number, lines.nct, lines.nct_line);
    }
    return lines;
}

std::string in_line(std::string_view what, std::size_t line) {
    return std::string(what) + " in line " + std::to_string(line) + ")";
}

// Extensions that are worth opening. Files without one are when they are named like a program: O9100.
constexpr std::string_view extensions[] = {"nc",  "ncc", "ncf", "cnc", "tap", "ngc", "gcode",
                                           "gc",  "g",   "eia", "iso", "pim", "min", "fan",
                                           "nct", "mac", "prg", "pgm", "sub", "txt"};

bool is_program_name(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
    return name.size() >= 2 && upper(name[0]) == 'O' && std::ranges::all_of(name.substr(1), is_digit);
}

} // namespace

Detection detect_dialect(const Source& source) {
    const Dialect* fanuc = find_dialect("fanuc");
    const std::string extension = extension_of(source.path());
    std::string_view text = source.bytes();
    switch (classify(text)) {
    case Content::empty: return {fanuc, "an empty file", false};
    case Content::utf16: return {nullptr, "UTF-16 text, which no control reads", true};
    case Content::binary: return {nullptr, "a binary file", true};
    case Content::text: break;
    }
    if (source.has_byte_order_mark()) text.remove_prefix(byte_order_mark_length(text));
    text = text.substr(0, looked_at);
    if (const std::optional<std::string> other = other_text(text)) return {nullptr, *other, true};

    const Lines lines = count_lines(text);
    if (lines.klartext >= 2 || (lines.klartext == 1 && lines.klartext_line <= 5))
        return {nullptr, in_line("HEIDENHAIN Klartext (BEGIN PGM or the like", lines.klartext_line), false};
    if (lines.din_plus != 0)
        return {nullptr, in_line("HEIDENHAIN DIN PLUS (a section word", lines.din_plus_line), false};
    if (lines.o_words != 0)
        return {nullptr, in_line("LinuxCNC (an o-word or a named parameter", lines.o_word_line), false};
    if (lines.remarks >= 3)
        return {nullptr, in_line("a wire-erosion control or the like (remarks with //", lines.remark_line),
                false};
    if (extension == "mpf" || extension == "spf" || extension == "arc")
        return {nullptr, "SINUMERIK (extension ." + extension + ")", false};
    if (lines.siemens >= 4) return {nullptr, in_line("SINUMERIK (its words", lines.siemens_line), false};
    if (lines.blocks * 3 < lines.filled) return {nullptr, "no NC program (few lines look like blocks)", true};
    if (has_nct_head(lines.first) && lines.nct != 0)
        return {find_dialect("nct"), in_line("content (an NCT form", lines.nct_line), false};
    return {fanuc, extension.empty() ? std::string("content") : "extension ." + extension + " and content",
            false};
}

bool has_nc_extension(std::string_view path) {
    const std::string extension = extension_of(path);
    if (extension.empty()) return is_program_name(path);
    return std::ranges::find(extensions, extension) != std::end(extensions);
}

} // namespace maclint
