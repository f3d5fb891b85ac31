//! The bytes of a file after its edits.
#pragma once

#include "rules/finding.hpp"

#include <span>
#include <string>
#include <variant>

namespace maclint::cli {

/// Why an edit cannot be made: "'–' cannot be written in shift-jis".
struct NotEditable {
    std::string why;
};

/// The file as it is stored, in its encoding, with the edits in it. They are in the order of the text and
/// touch not; their line ends become the file's. All other bytes stay as they are.
[[nodiscard]] std::variant<std::string, NotEditable> edited_text(const Source& source,
                                                                 std::span<const Edit> edits);

} // namespace maclint::cli
