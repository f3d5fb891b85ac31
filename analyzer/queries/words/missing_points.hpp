//! Lengths that stand without a decimal point in files whose lengths have one.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace maclint {

struct ProgramFile;

namespace queries {

/// A word with a whole number other than 0: a post processor that leaves out what is 0 behind the point still
/// writes X12.5.
struct LengthWord {
    const Program* program;
    Span word;
    std::string_view address;
    Literal number;
};

struct Lengths {
    std::size_t count = 0;         ///< of moves, those without a point included
    std::vector<LengthWord> bare;  ///< without a point
    std::vector<LengthWord> times; ///< of dwells: X, U or P beside G4

    /// Whether nine of ten whole lengths of moves have a point, and ten at least: one without it is a slip.
    [[nodiscard]] bool have_points() const;
};

/// Of the moves and dwells of a file: X, Y, Z, U, V, W, and I, J, K, R beside G2 and G3. Nothing where the
/// control counts in millimetres. Programs as long as only a post processor writes them, which does all
/// alike, are left out.
[[nodiscard]] Lengths lengths_of(const ProgramFile& file);

} // namespace queries

} // namespace maclint
