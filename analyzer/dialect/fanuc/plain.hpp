//! What the plain scanner has to know of the dialect.
#pragma once

#include "analyzer/dialect/fanuc/codes.hpp"
#include "analyzer/syntax/plain_tables.hpp"

namespace maclint::fanuc {

/// The scanner's tables for the codes of a machine type.
[[nodiscard]] syntax::PlainTables plain_tables(const CodeTable& codes);

} // namespace maclint::fanuc
