//! JSON with comments in which every key and value knows where it stands in the text.
#pragma once

#include "analyzer/source/span.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::cli {

struct JsonMember;

/// One value. `span` covers the text of strings and numbers with their quotes; elsewhere the bracket that
/// closes.
struct JsonNode {
    using Array = std::vector<JsonNode>;
    using Object = std::vector<JsonMember>;
    std::variant<std::nullptr_t, bool, double, std::string, Array, Object> value;
    Span span;
};

struct JsonMember {
    std::string key;
    Span key_span;
    JsonNode node;
};

struct JsonError {
    Offset at;
    std::string message;             ///< what is wrong, without a full stop
    std::string cure = "Correct it"; ///< what to do, likewise
};

/// Parses the text; `//` and `/* */` comments are allowed, and a comma before a closing bracket.
[[nodiscard]] std::variant<JsonNode, JsonError> parse_json(std::string_view text);

} // namespace maclint::cli
