//! Regular plurals are all that is needed.
#include "cli/text/shown.hpp"

#include "analyzer/source/encoding.hpp"

namespace maclint::cli {

std::string counted(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string shown(std::string_view bytes) { return printable(to_utf8(bytes, detect_encoding(bytes))); }

} // namespace maclint::cli
