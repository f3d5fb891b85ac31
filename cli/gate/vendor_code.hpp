//! What a maker's programs are told of: errors only, unless somebody asks for more.
#pragma once

#include "cli/engine/engine.hpp"
#include "cli/notice.hpp"

#include <optional>

namespace maclint::cli {

/// Marks what does not count, and says how much it is; nothing where it is none.
[[nodiscard]] std::optional<Notice> withhold_vendor_code(Result& result);

} // namespace maclint::cli
