//! Where a program names variables by their numbers, and what the control has there.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/program/variable_tables.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// A variable of the machine, or one that there is not, which a program reads or writes: by its number, or by
/// an index that numbers alone decide, `#[5000+1]`.
struct NumberUse {
    std::int64_t number;
    const VariableRange* range; ///< nullptr: no row holds the number
    Span span;                  ///< of the variable
    bool written;

    [[nodiscard]] bool is_absent() const { return range == nullptr || range->meaning == Meaning::absent; }
    /// Whether a program may not store anything there.
    [[nodiscard]] bool is_protected() const { return !is_absent() && range->on_write == OnWrite::forbidden; }
    /// Whether there is nothing to read: what is stored there stops the program.
    [[nodiscard]] bool is_write_only() const {
        return !is_absent() && (range->on_write == OnWrite::alarm || range->on_write == OnWrite::pause);
    }
};

/// In the order of the text.
[[nodiscard]] std::vector<NumberUse> uses_of_numbers(const Program& program);

/// Whether nothing but memory speaks for a row: its source begins with "T", or nobody knows.
[[nodiscard]] bool rests_on_memory(const VariableRange& range);

/// "#5063", as the variables of the family are written.
[[nodiscard]] std::string spell_number(const Program& program, std::int64_t number);

} // namespace maclint::queries
