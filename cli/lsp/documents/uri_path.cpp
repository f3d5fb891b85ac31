//! file:///c%3A/shop/O1.nc and file://server/shop/O1.nc (RFC 8089).
#include "cli/lsp/documents/uri_path.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "cli/text/letters.hpp"

#include <cctype>
#include <charconv>
#include <filesystem>

namespace maclint::cli::lsp {
namespace {

std::string percent_decoded(std::string_view text) {
    constexpr int hexadecimal = 16;
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned value = 0;
        const char* const digits = text.data() + i + 1;
        if (text[i] == '%' && i + 2 < text.size() &&
            std::from_chars(digits, digits + 2, value, hexadecimal).ptr == digits + 2) {
            out += static_cast<char>(value);
            i += 2;
        } else {
            out += text[i];
        }
    }
    return out;
}

/// "/c:/shop" is "C:/shop".
std::string without_slash_of_drive(std::string path) {
    const bool has_drive = path.size() > 2 && path[0] == '/' && path[2] == ':' &&
                           std::isalpha(static_cast<unsigned char>(path[1])) != 0;
    if (!has_drive) return path;
    path.erase(0, 1);
    path.front() = in_upper_case(path.substr(0, 1)).front();
    return path;
}

} // namespace

std::optional<std::string> path_of_uri(std::string_view uri) {
    constexpr std::string_view scheme = "file:";
    if (in_lower_case(uri.substr(0, scheme.size())) != scheme) return std::nullopt;
    uri.remove_prefix(scheme.size());
    if (uri.starts_with("//")) {
        uri.remove_prefix(2);
        if (uri.starts_with("localhost/")) uri.remove_prefix(uri.find('/'));
        if (!uri.starts_with('/')) return "//" + percent_decoded(uri);
    }
    std::string path = without_slash_of_drive(percent_decoded(uri));
    if (path.empty() || path.find('\0') != std::string::npos) return std::nullopt;
    path = platform::text_of(platform::path_of(path).lexically_normal());
    if (path.size() > 1 && path.ends_with('/')) path.pop_back();
    return path;
}

} // namespace maclint::cli::lsp
