//! Says in one word what was detected.
#pragma once

#include "analyzer/dialect/dialect.hpp"

#include <string>
#include <string_view>

namespace maclint::test {

/// What `reported` says of DIN PLUS, whether the dialect is there or not.
inline constexpr std::string_view din_plus = "HEIDENHAIN DIN PLUS";

/// The dialect's name, or what the note calls the language: "SINUMERIK".
inline std::string reported(const Detection& detection) {
    if (detection.dialect == nullptr) return detection.reason.substr(0, detection.reason.find(" ("));
    if (detection.dialect->name == "dinplus") return std::string(din_plus);
    return std::string(detection.dialect->name);
}

} // namespace maclint::test
