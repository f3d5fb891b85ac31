//! Both kinds of slashes count, and the case of letters does not, as on Windows.
#include "cli/input/other_server.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

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

/// Puts the names of a path before those that are still to be gone through, which stand last one first.
void put_before(std::vector<fs::path>& names, const fs::path& path) {
    const std::vector<fs::path> more(path.begin(), path.end());
    names.insert(names.end(), more.rbegin(), more.rend());
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
    constexpr int most_links = 40; // as systems have it
    fs::path at = path.root_path();
    std::vector<fs::path> names;
    put_before(names, path.relative_path());
    for (int links = 0; !names.empty() && links <= most_links;) {
        const fs::path name = std::move(names.back());
        names.pop_back();
        if (name.empty() || name == ".") continue;
        if (name == "..") {
            at = at.parent_path();
            continue;
        }
        const auto target = platform::link_target(at / name);
        if (!target) {
            at /= name;
            continue;
        }
        ++links;
        const std::string written = platform::text_of(*target);
        if (names_other_server(written, from) && !begins_with_volume(with_slashes(written))) return true;
        if (target->has_root_directory()) at = target->has_root_name() ? target->root_path() : at.root_path();
        put_before(names, target->relative_path());
    }
    return false;
}

} // namespace maclint::cli
