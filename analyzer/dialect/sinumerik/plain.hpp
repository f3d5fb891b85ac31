//! What the plain scanner has to know of the dialect.
#pragma once

#include "analyzer/syntax/plain_tables.hpp"

namespace maclint::sinumerik {

[[nodiscard]] const syntax::PlainTables& plain_tables();

} // namespace maclint::sinumerik
