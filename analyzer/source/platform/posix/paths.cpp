//! A path is its bytes.
#include "analyzer/source/platform/paths.hpp"

namespace maclint::platform {

bool paths_may_name_servers() { return false; }
std::filesystem::path path_of(std::string_view text) { return {text}; }
std::string text_of(const std::filesystem::path& path) { return path.string(); }

} // namespace maclint::platform
