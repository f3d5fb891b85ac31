//! Programs whose first remarks say that somebody holds rights to them: a maker's, whose users will not
//! change them.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace maclint {

/// Whether the remark (its text, in any encoding) claims rights: "COPYRIGHT*1990-2022", "(C) 2010 MAKER",
/// "ALLE RECHTE VORBEHALTEN". A letter C with a number is an address, and rights to the post-processor that
/// wrote a program are none to the program.
[[nodiscard]] bool claims_rights(std::string_view remark);

struct ProgramWithRights {
    Span program;
    Span remark;
};

/// Of the file's programs those with such a remark before their first block that does something. One before
/// the first program is there for all.
[[nodiscard]] std::vector<ProgramWithRights> programs_with_rights(const ProgramFile& file);

} // namespace maclint
