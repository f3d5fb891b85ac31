//! Remarks for readers who do not see the line that they are about.
#pragma once

#include "rules/finding.hpp"

#include <cstdint>
#include <string>

namespace maclint::cli {

/// Where a remark is read: beside its line, or without it.
enum class Remarks : std::uint8_t { beside_code, alone };

/// "'[#13EQ0]' is false" where a text report writes "false" beside the block.
[[nodiscard]] std::string remark_of(const RelatedLocation& related, Remarks remarks);

} // namespace maclint::cli
