//! Paths to URIs.
#include "cli/report/uri.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "cli/input/repository.hpp"

#include <cctype>
#include <filesystem>
#include <utility>

namespace maclint::cli {

namespace fs = std::filesystem;

std::string source_root() {
    std::error_code error;
    const fs::path here = fs::current_path(error);
    return platform::text_of(repository_around(here).value_or(here));
}

PlacedPath placed_path(const std::string& path, const std::string& root) {
    std::error_code error;
    const fs::path absolute = fs::absolute(platform::path_of(path), error).lexically_normal();
    const fs::path relative = absolute.lexically_relative(platform::path_of(root));
    if (relative.empty() || relative == "." || *relative.begin() == "..")
        return {platform::text_of(absolute), false};
    return {platform::text_of(relative), true};
}

FileUri uri_of(const std::string& path, const std::string& root) {
    const PlacedPath placed = placed_path(path, root);
    return {placed.below_root ? percent_encoded(placed.path) : file_uri(placed.path), placed.below_root};
}

std::string file_uri(std::string_view absolute) {
    if (absolute.starts_with("//")) return "file:" + percent_encoded(absolute);
    if (absolute.starts_with('/')) return "file://" + percent_encoded(absolute);
    const std::size_t drive = absolute.find(':') + 1;
    return "file:///" + std::string(absolute.substr(0, drive)) + percent_encoded(absolute.substr(drive));
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
