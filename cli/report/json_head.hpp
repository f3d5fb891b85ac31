//! What lists and pages in JSON begin with; docs/json.md describes them.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace maclint::cli {

/// `version` of the format and `tool`. Keys are added, never changed, within a version.
[[nodiscard]] nlohmann::ordered_json json_head();

/// The text of it, whatever bytes programs and file names brought into it.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

} // namespace maclint::cli
