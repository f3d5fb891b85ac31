//! What users read of the exemptions of rules.
#pragma once

#include "cli/report/plain_page.hpp"

#include <string>

namespace maclint::cli {

/// The exemptions of the rule as a chapter of its page; empty where it has none.
[[nodiscard]] std::string markdown_exemptions(const Rule& rule);
void add_exemptions(const Rule& rule, PlainPage& page);

[[nodiscard]] std::string plain_exemption_page(const NamedExemption& exemption, const PageStyle& style);

} // namespace maclint::cli
