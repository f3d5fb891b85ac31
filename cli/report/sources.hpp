//! The documents that rules name by keys.
#pragma once

#include <string>
#include <string_view>

namespace maclint::cli {

/// The document of a source such as "SEED-001:206", as docs/sources.md has it; empty for a key that stands
/// for none.
[[nodiscard]] std::string_view document_of(std::string_view source);

/// A source for readers who do not know the keys: the document, the place in it, and the key that
/// docs/sources.md lists. A source that stands for itself is as it is written.
[[nodiscard]] std::string source_sentence(std::string_view source);

} // namespace maclint::cli
