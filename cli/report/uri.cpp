//! Paths to URIs.
#include "cli/report/uri.hpp"

#include "cli/input/repository.hpp"

#include <cctype>
#include <filesystem>
#include <utility>

namespace maclint::cli {

namespace fs = std::filesystem;

std::string source_root() {
    std::error_code error;
    const fs::path here = fs::current_path(error);
    return repository_around(here).value_or(here).string();
}

PlacedPath placed_path(const std::string& path, const std::string& root) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error).lexically_normal();
    std::string relative = absolute.lexically_relative(root).generic_string();
    if (relative.empty() || relative == "." || relative.starts_with(".."))
        return {absolute.generic_string(), false};
    return {std::move(relative), true};
}

FileUri uri_of(const std::string& path, const std::string& root) {
    const PlacedPath placed = placed_path(path, root);
    return {(placed.below_root ? "" : "file://") + percent_encoded(placed.path), placed.below_root};
}

std::string percent_encoded(std::string_view path) {
    std::string out;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 ||
                                           std::string_view("-._~/").find(c) != std::string_view::npos);
        if (plain) {
            out += c;
        } else {
            constexpr std::string_view digits = "0123456789ABCDEF";
            out += '%';
            out += digits[byte >> 4U];
            out += digits[byte & 0xFU];
        }
    }
    return out;
}

} // namespace maclint::cli
