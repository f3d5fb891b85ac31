//! Paths that lead to another computer: Windows sends the user's name and a proof of the password along.
#pragma once

#include <string_view>

namespace maclint::cli {

/// Whether Windows takes the path for one of a server, or for one of its own kinds that may be one:
/// \\server\share, //server/share, \\?\UNC\server\share.
[[nodiscard]] bool names_server(std::string_view path);

/// Whether two such paths name the same share of the same server, in any case of letters.
[[nodiscard]] bool are_on_same_share(std::string_view one, std::string_view other);

} // namespace maclint::cli
