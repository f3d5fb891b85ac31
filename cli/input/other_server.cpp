//! Both kinds of slashes count, and the case of letters does not, as on Windows.
#include "cli/input/other_server.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "cli/input/links.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

std::string with_slashes(std::string_view path) {
    std::string text = in_lower_case(path);
    std::ranges::replace(text, '\\', '/');
    return text;
}

/// `\\.\`, `\\?\` and `\??\`; `\\?\Volume{…}`, which links to local volumes say, is as near as a drive.
bool begins_with_device(std::string_view path) {
    const std::string_view head = path.substr(0, 4);
    // The last one in two parts: "??/" is a trigraph, which some compilers take for a backslash.
    return head == "//./" || head == "//?/" ||
           head == "/?"
                   "?/";
}
bool begins_with_volume(std::string_view path) {
    constexpr std::string_view volume = "volume{";
    return begins_with_device(path) && path.substr(4).starts_with(volume);
}

/// "//server/share", or nothing.
std::string_view share_of(std::string_view path) {
    if (!path.starts_with("//") || begins_with_device(path)) return {};
    const auto server_end = path.find('/', 2);
    return path.substr(0, server_end == std::string_view::npos ? server_end : path.find('/', server_end + 1));
}

/// "c", or nothing.
std::string_view drive_of(std::string_view path) {
    const bool has =
        path.size() > 1 && path[1] == ':' && std::isalpha(static_cast<unsigned char>(path[0])) != 0;
    return has ? path.substr(0, 1) : std::string_view{};
}

} // namespace

bool names_other_server(std::string_view written, std::string_view from) {
    const std::string path = with_slashes(written);
    if (begins_with_device(path)) return true;
    const std::string_view share = share_of(path);
    return !share.empty() && share != share_of(with_slashes(from));
}

bool names_other_drive(std::string_view written, std::string_view from) {
    const std::string path = with_slashes(written);
    const std::string_view drive = drive_of(path);
    if (drive.empty()) return false;
    return drive != drive_of(with_slashes(from)) || path.substr(2, 1) != "/";
}

bool leads_to_other_server(const fs::path& path, std::string_view from) {
    bool found = false;
    static_cast<void>(follow_links(path, [&](const fs::path& target) {
        const std::string written = platform::text_of(target);
        found = names_other_server(written, from) && !begins_with_volume(with_slashes(written));
        return !found;
    }));
    return found;
}

} // namespace maclint::cli
