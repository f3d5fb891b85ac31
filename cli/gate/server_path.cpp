//! By the first letters, then by the first two names.
#include "cli/gate/server_path.hpp"

#include "cli/suggest.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace maclint::cli {
namespace {

/// In small letters and with '/' alone.
std::string in_one_form(std::string_view path) {
    std::string text = in_lower_case(path);
    std::ranges::replace(text, '\\', '/');
    return text;
}

/// "server/share"; nothing where the path has no such names.
std::optional<std::string> share_of(std::string_view path) {
    std::string text = in_one_form(path);
    // Two question marks in a row would be read as a trigraph by some.
    for (const std::string_view prefix : {"//?/unc/", "//./unc/",
                                          "/?"
                                          "?/unc/",
                                          "//"}) {
        if (!text.starts_with(prefix)) continue;
        text.erase(0, prefix.size());
        const auto server = text.find('/');
        if (server == 0 || server == std::string::npos || text.starts_with("?/") || text.starts_with("./"))
            return std::nullopt;
        const auto share = text.find('/', server + 1);
        if (share == server + 1 || server + 1 == text.size()) return std::nullopt;
        return text.substr(0, share);
    }
    return std::nullopt;
}

} // namespace

bool names_server(std::string_view path) {
    const std::string text = in_one_form(path);
    return text.starts_with("//") || text.starts_with("/?"
                                                      "?/");
}

bool are_on_same_share(std::string_view one, std::string_view other) {
    const auto share = share_of(one);
    return share && share == share_of(other);
}

} // namespace maclint::cli
