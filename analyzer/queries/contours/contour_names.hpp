//! Names of contours: which a file describes, and which its blocks ask for.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// The text that the word holds, without its quotation marks; nothing where it holds none.
[[nodiscard]] std::optional<std::string_view> text_of(const Program& program, const Word& word);

/// A name, and the word that holds it; of a section its heading.
struct ContourName {
    std::string_view name;
    Span span;
    std::string_view code = {}; ///< of the block that asks for it: "G810"
    bool is_blank = false;      ///< it is one of a blank, or asks for one
};

struct ContourNames {
    std::vector<ContourName> described, wanted;
    bool is_complete = true;   ///< no subprogram may describe more
    bool has_branches = false; ///< which of them are described is decided while the program is read
};

/// Those of one file.
[[nodiscard]] ContourNames contour_names(const ProgramFile& file);

/// Without blanks, in capitals: two that are the same so are one for a reader.
[[nodiscard]] std::string squeezed(std::string_view name);

} // namespace maclint::queries
