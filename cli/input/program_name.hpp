//! Names that NC programs bear.
#pragma once

#include <string_view>

namespace maclint::cli {

/// Whether only an NC program is named so: neither a text of any kind (.txt, .h) nor anything else.
[[nodiscard]] bool is_named_like_program(std::string_view path);

/// Whether something else is named so: main.py, drawing.pdf.
[[nodiscard]] bool is_named_like_other(std::string_view path);

} // namespace maclint::cli
