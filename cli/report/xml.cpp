//! Escapes for XML 1.0 (fifth edition), sections 2.2 and 2.4.
#include "cli/report/xml.hpp"

namespace maclint::cli {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";
/// U+FFFE and U+FFFF, the only characters beyond the controls that XML does not take, differ in their last
/// byte.
constexpr std::string_view no_characters = "\xEF\xBF";

bool is_no_character(std::string_view text) {
    return text.starts_with(no_characters) && text.size() > 2 && (text[2] == '\xBE' || text[2] == '\xBF');
}

} // namespace

std::string xml_escaped(std::string_view utf8) {
    std::string out;
    out.reserve(utf8.size());
    for (std::size_t at = 0; at < utf8.size(); ++at) {
        const char c = utf8[at];
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        case '\t': out += "&#9;"; break; // in an attribute it would become a blank
        case '\n': out += c; break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) {
                out += replacement;
            } else if (is_no_character(utf8.substr(at))) {
                out += replacement;
                at += 2;
            } else {
                out += c;
            }
        }
    }
    return out;
}

std::string xml_attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + xml_escaped(value) + "\"";
}

} // namespace maclint::cli
