//! Escapes for XML 1.0 (fifth edition), sections 2.2 and 2.4.
#include "cli/report/xml.hpp"

#include "analyzer/source/encoding.hpp"

namespace maclint::cli {
namespace {

/// The production Char, without the tab and the line ends. Bytes that are no UTF-8, surrogates among them, do
/// not get here.
bool is_char(char32_t character) {
    return (character >= 0x20 && character <= 0xD7FF) || (character >= 0xE000 && character <= 0xFFFD) ||
           (character >= 0x10000 && character <= 0x10FFFF);
}

} // namespace

std::string xml_escaped(std::string_view text) {
    const std::string utf8 = to_utf8(text, Encoding::utf8);
    std::string out;
    out.reserve(utf8.size());
    for (std::string_view rest = utf8; !rest.empty();) {
        const auto [character, length] = first_character(rest);
        const std::string_view bytes = rest.substr(0, length);
        rest.remove_prefix(length);
        switch (character) {
        case U'&': out += "&amp;"; break;
        case U'<': out += "&lt;"; break;
        case U'>': out += "&gt;"; break;
        case U'"': out += "&quot;"; break;
        case U'\t': out += "&#9;"; break; // in an attribute it would become a blank
        case U'\n': out += '\n'; break;
        case U'\r': out += "&#13;"; break; // it would become a line feed
        default: out += is_char(character) ? std::string(bytes) : printable(bytes);
        }
    }
    return out;
}

std::string xml_attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + xml_escaped(value) + "\"";
}

} // namespace maclint::cli
