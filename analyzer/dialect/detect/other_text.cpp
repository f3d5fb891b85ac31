//! Told by the first characters, sources of other languages by a few of their lines.
#include "analyzer/dialect/detect/other_text.hpp"

#include "analyzer/dialect/detect/line.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

namespace maclint::detect {
namespace {

constexpr std::string_view pdf_head = "%PDF-";

bool is_c_sign(std::string_view line) {
    static constexpr std::string_view heads[] = {"#include", "#define",  "#ifndef",    "#ifdef", "#pragma",
                                                 "int main", "typedef ", "namespace ", "/*"};
    constexpr std::string_view beginnings = "#itn/"; // of these heads
    const bool may_be_head = beginnings.find(line.front()) != std::string_view::npos;
    return (may_be_head && starts_with_any(line, heads)) || line.ends_with("{");
}

bool is_python_sign(std::string_view line) {
    static constexpr std::string_view imports[] = {"import ", "from "};
    static constexpr std::string_view openings[] = {"def ", "class ", "async def "};
    if (line.front() == 'i' || line.front() == 'f') return starts_with_any(line, imports);
    const bool opens = line.ends_with(":") && starts_with_any(line, openings);
    return opens || line.starts_with("\"\"\"");
}

bool is_markdown_sign(std::string_view line) {
    static constexpr std::string_view heads[] = {"## ", "### ", "```", "|--", "| --"};
    return (line.front() == '#' || line.front() == '`' || line.front() == '|') &&
           starts_with_any(line, heads);
}

/// The language that at least two of the first lines, blanks around them left out, are signs of.
std::optional<std::string_view> find_source_language(std::string_view text) {
    constexpr int most_lines = 200;
    constexpr int enough = 2;
    int of_c = 0, of_python = 0, of_markdown = 0;
    int lines = 0;
    LineEnds ends(text);
    for (std::size_t at = 0; at < text.size() && lines < most_lines; ++lines) {
        const std::size_t end = ends.from(at);
        const std::string_view line = trim(text.substr(at, end - at));
        at = end + 1;
        if (line.empty()) continue;
        of_c += is_c_sign(line) ? 1 : 0;
        of_python += is_python_sign(line) ? 1 : 0;
        of_markdown += is_markdown_sign(line) ? 1 : 0;
    }
    if (of_c >= enough) return "C source";
    if (of_python >= enough) return "Python source";
    if (of_markdown >= enough) return "Markdown";
    return std::nullopt;
}

/// `<?xml`, `<!doctype`, or a tag at the head and one that is closed: `<PART>` is the name of a program.
bool is_markup(std::string_view text) {
    if (text.size() < 3 || text[0] != '<') return false;
    if (text[1] == '?' || text[1] == '!') return is_letter(text[2]) || text[2] == '-';
    return is_letter(text[1]) &&
           (text.find("</") != std::string_view::npos || text.find("/>") != std::string_view::npos);
}

/// Whether texts, numbers and brackets that match are all that stands in the list at the head of the text,
/// and nothing stands after it. `[Part "A1"]` is a comment of DIN PLUS.
bool is_json_list(std::string_view text) {
    constexpr std::string_view between = " \t\r\n,:";
    static constexpr std::string_view names[] = {"true", "false", "null"};
    std::string open;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (between.find(c) != std::string_view::npos) {
            ++at;
        } else if (at != 0 && open.empty()) {
            return false;
        } else if (c == '[' || c == '{') {
            open += c == '[' ? ']' : '}';
            ++at;
        } else if (c == ']' || c == '}') {
            if (c != open.back()) return false;
            open.pop_back();
            ++at;
        } else if (c == '"') {
            while (++at < text.size() && text[at] != '"')
                if (text[at] == '\\') ++at;
            ++at;
        } else if (is_digit(c) || c == '-') {
            at = std::min(text.find_first_not_of("0123456789+-.eE", at), text.size());
        } else {
            const auto* const name = std::ranges::find_if(
                names, [&](std::string_view word) { return text.substr(at).starts_with(word); });
            if (name == std::end(names)) return false;
            at += name->size();
        }
    }
    return true;
}

} // namespace

std::optional<std::string_view> find_other_text(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return std::nullopt;
    text.remove_prefix(first);
    if (text.starts_with("{\\rtf")) return "RTF";
    if (text.front() == '{' || (text.front() == '[' && is_json_list(text))) return "JSON";
    if (is_markup(text)) return "XML or HTML";
    if (text.starts_with("#!")) return "a script";
    if (text.starts_with(pdf_head)) return "PDF";
    return find_source_language(text);
}

std::optional<std::string_view> find_binary_kind(std::string_view bytes) {
    struct Kind {
        std::string_view head, name;
    };
    static constexpr Kind kinds[] = {{"\x89PNG", "PNG image"},
                                     {"\xFF\xD8\xFF", "JPEG image"},
                                     {"GIF8", "GIF image"},
                                     {pdf_head, "PDF"},
                                     {"PK\x03\x04", "ZIP archive"},
                                     {"\x1F\x8B", "gzip archive"},
                                     {"7z\xBC\xAF", "7z archive"},
                                     {"\x7F"
                                      "ELF",
                                      "ELF program"},
                                     {"MZ", "Windows program"}};
    for (const auto& [head, name] : kinds)
        if (bytes.starts_with(head)) return name;
    return std::nullopt;
}

} // namespace maclint::detect
