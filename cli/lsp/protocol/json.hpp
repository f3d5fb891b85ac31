//! JSON of the protocol, and what is read from the parameters of messages.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace maclint::cli::lsp {

using Json = nlohmann::json;

/// As JSON-RPC 2.0 and LSP 3.17 number them.
enum class ErrorCode : std::int32_t {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    internal_error = -32603,
    not_initialized = -32002,
    cancelled = -32800,
    request_failed = -32803,
};

/// What a request is answered with that cannot be done. Thrown by handlers, caught where they are called.
struct ResponseError {
    ErrorCode code;
    std::string message; ///< "what. Cure."
};

/// The member, whatever it is; ResponseError where there is none.
[[nodiscard]] const Json& member(const Json& object, std::string_view name);
/// The string of that name, at most as long as a message.
[[nodiscard]] const std::string& string_in(const Json& object, std::string_view name);
/// The whole number of that name, as far as 2^53 either way.
[[nodiscard]] std::int64_t integer_in(const Json& object, std::string_view name);

/// What the names lead to, one inside the other; nullptr where one is missing.
[[nodiscard]] const Json* find(const Json& object, std::initializer_list<std::string_view> names);
/// Whether they lead to true.
[[nodiscard]] bool is_true(const Json& object, std::initializer_list<std::string_view> names);

/// The text of a message: valid UTF-8, whatever its strings hold.
[[nodiscard]] std::string text_of(const Json& json);

} // namespace maclint::cli::lsp
