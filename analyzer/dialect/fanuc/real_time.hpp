//! Real-time macros: statements behind `//` that the control runs beside the blocks of a program.
#pragma once

#include "analyzer/program/syntax_error.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/source/span.hpp"

#include <optional>
#include <string_view>

namespace maclint::fanuc {

/// `//1 ZONCE[#RV[0]EQ1]#IOG[2]=1`. Where the control may be another than one that has them, their own words
/// tell.
[[nodiscard]] bool is_real_time(std::string_view text, Span block, const ControlModel& control);

/// What the control stops at in such a statement; nothing on controls that may not have them.
[[nodiscard]] std::optional<SyntaxError> find_real_time_fault(std::string_view text, Span block,
                                                              const ControlModel& control);

} // namespace maclint::fanuc
