//! What the plain scanner tells of the words and codes of rows.
#pragma once

#include "analyzer/syntax/plain_tables.hpp"
#include "rules/words/rule_row.hpp"

#include <string_view>

namespace maclint {

/// The addresses of the list that scanning tells apart.
[[nodiscard]] syntax::AddressSet scanned_surely(const syntax::PlainTables& tables, std::string_view list);
/// And those that have no name, among which one of the list may be that has no number of its own.
[[nodiscard]] syntax::AddressSet scanned_maybe(const syntax::PlainTables& tables, std::string_view list);

/// By which scanning knows the row's code; `tables` may be nullptr.
[[nodiscard]] syntax::CodeSet::Kind scanned_kind(const syntax::PlainTables* tables, const RowForCode& row);

} // namespace maclint
