//! Where files are for those who read a report elsewhere: URIs below the root of the sources.
#pragma once

#include <string>
#include <string_view>

namespace maclint::cli {

/// A path as a URI. Below the root it is relative, otherwise absolute with the scheme "file".
struct FileUri {
    std::string uri; ///< percent-encoded
    bool below_root;
};

/// The folder that relative URIs start from: the repository that holds the current folder, else that folder.
[[nodiscard]] std::string source_root();

/// A path as it is told from the root: below it relative, otherwise absolute, with '/' on every system.
struct PlacedPath {
    std::string path;
    bool below_root;
};
[[nodiscard]] PlacedPath placed_path(const std::string& path, const std::string& root);

[[nodiscard]] FileUri uri_of(const std::string& path, const std::string& root);

/// That of a path from the root of a file system: "/shop/O1.nc", on Windows "C:/shop/O1.nc" and
/// "//server/shop/O1.nc", whose server the URI names as its own.
[[nodiscard]] std::string file_uri(std::string_view absolute);

/// Everything but unreserved characters (RFC 3986, section 2.3) and '/' is encoded.
[[nodiscard]] std::string percent_encoded(std::string_view path);

} // namespace maclint::cli
