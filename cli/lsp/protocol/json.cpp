//! Members are looked for by name; what is missing or of another kind is the sender's error.
#include "cli/lsp/protocol/json.hpp"

namespace maclint::cli::lsp {
namespace {

[[noreturn]] void refuse_params(std::string_view name, std::string_view wanted) {
    throw ResponseError{ErrorCode::invalid_params, "The parameters have no '" + std::string(name) +
                                                       "' that is " + std::string(wanted) +
                                                       ". Send one as LSP 3.17 describes it."};
}

} // namespace

const Json& member(const Json& object, std::string_view name) {
    const Json* found = find(object, {name});
    if (found == nullptr) refuse_params(name, "there");
    return *found;
}

const std::string& string_in(const Json& object, std::string_view name) {
    const Json& found = member(object, name);
    if (!found.is_string()) refuse_params(name, "a string");
    return found.get_ref<const std::string&>();
}

std::int64_t integer_in(const Json& object, std::string_view name) {
    constexpr std::int64_t most = std::int64_t{1} << 53U;
    const Json& found = member(object, name);
    if (!found.is_number_integer()) refuse_params(name, "a whole number");
    const auto value = found.get<std::int64_t>();
    if (value > most || value < -most) refuse_params(name, "a whole number");
    return value;
}

const Json* find(const Json& object, std::initializer_list<std::string_view> names) {
    const Json* at = &object;
    for (const std::string_view name : names) {
        if (!at->is_object()) return nullptr;
        const auto found = at->find(name);
        if (found == at->end()) return nullptr;
        at = &*found;
    }
    return at;
}

bool is_true(const Json& object, std::initializer_list<std::string_view> names) {
    const Json* found = find(object, names);
    return found != nullptr && found->is_boolean() && found->get<bool>();
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

} // namespace maclint::cli::lsp
