//! Text in XML reports.
#pragma once

#include <string>
#include <string_view>

namespace maclint::cli {

/// The text fit for the content of an element and for an attribute in double quotes. Characters that XML 1.0
/// has no place for, not even as references, are written as `printable` has them; bytes that are no UTF-8
/// become U+FFFD.
[[nodiscard]] std::string xml_escaped(std::string_view text);

/// ` name="value"`, the value escaped.
[[nodiscard]] std::string xml_attribute(std::string_view name, std::string_view value);

} // namespace maclint::cli
