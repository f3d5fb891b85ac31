//! One version for all of them.
#include "cli/report/json_head.hpp"

#include "analyzer/source/encoding.hpp"

#include <nlohmann/json.hpp>

namespace maclint::cli {

nlohmann::ordered_json json_head() {
    constexpr int version = 1;
    return {{"version", version}, {"tool", {{"name", "maclint"}, {"version", MACLINT_VERSION}}}};
}

std::string json_text(const nlohmann::ordered_json& json) {
    return printable_json(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

} // namespace maclint::cli
