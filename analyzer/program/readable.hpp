//! How much of a file its dialect could read: a text in another language shows by what it could not.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstddef>

namespace maclint {

struct Readable {
    std::size_t blocks = 0, unreadable = 0;

    /// More than a quarter of a text that is long enough to judge by: what a person wrote in haste for this
    /// language is never that bad.
    [[nodiscard]] bool is_doubtful() const;
};

[[nodiscard]] Readable count_readable(const ProgramFile& file);

} // namespace maclint
