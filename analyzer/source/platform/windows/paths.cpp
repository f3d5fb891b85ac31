//! UTF-8 here, UTF-16 there.
#include "analyzer/source/platform/paths.hpp"

#include "analyzer/source/platform/windows/system.hpp"

#include <algorithm>

namespace maclint::platform {

bool paths_may_name_servers() { return true; }

std::filesystem::path path_of(std::string_view text) { return {wide(text)}; }

std::string text_of(const std::filesystem::path& path) {
    std::string text = narrow(path.native());
    std::ranges::replace(text, '\\', '/');
    return text;
}

} // namespace maclint::platform
