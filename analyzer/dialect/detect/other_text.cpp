//! Told by the first characters, C source by a few of its lines.
#include "analyzer/dialect/detect/other_text.hpp"

#include "analyzer/dialect/detect/line.hpp"

#include <algorithm>

namespace maclint::detect {
namespace {

bool is_c_source(std::string_view text) {
    static constexpr std::string_view heads[] = {"#include", "#define",  "#ifndef",    "#ifdef", "#pragma",
                                                 "int main", "typedef ", "namespace ", "/*"};
    constexpr int most_lines = 200;
    int signs = 0;
    int lines = 0;
    for (std::size_t at = 0; at < text.size() && lines < most_lines; ++lines) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const std::string_view line = trim(text.substr(at, end - at));
        if (starts_with_any(line, heads) || line.ends_with("{")) ++signs;
        at = end + 1;
    }
    return signs >= 2;
}

} // namespace

std::optional<std::string_view> find_other_text(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return std::nullopt;
    text.remove_prefix(first);
    constexpr std::size_t near = 20;
    if (text.front() == '{' || (text.front() == '[' && text.find_first_of("{\"") < near)) return "JSON";
    static constexpr std::string_view markup[] = {"<?xml", "<!DOCTYPE", "<html"};
    if (starts_with_any(text, markup)) return "XML or HTML";
    if (text.starts_with("#!")) return "a script";
    if (is_c_source(text)) return "C source";
    return std::nullopt;
}

} // namespace maclint::detect
