//! The places of a finding in the order in which a reader needs them: one row for each source line.
#pragma once

#include "cli/report/remark.hpp"
#include "cli/report/report.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace maclint::cli {

/// A line of a program with what is said of it.
struct Row {
    const Source* source;
    std::uint32_t line; ///< of the span's begin
    Span span;          ///< what the first remark is about; of the finding's own row its place
    std::string remark; ///< may be empty
    bool own;           ///< the finding's place is here
};

/// The way to the finding's place, the place, and what is said after it.
struct Rows {
    std::vector<Row> rows;
    std::size_t left_out = 0; ///< rows that there are beside these
};

[[nodiscard]] Rows rows_of(const Finding& finding, PathDetail detail, Remarks remarks);

} // namespace maclint::cli
