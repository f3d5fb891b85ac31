//! What shows that a program is not meant to run past its last block.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <variant>

namespace maclint::queries {

/// It uses an argument that only a call can have brought.
struct WrittenAsMacro {
    ExpressionId argument;
};

/// It saves its callers' modal state and puts it back.
struct KeepsState {
    const dataflow::Store* save;
};

/// A call of it, another exit that is reached, or how it is written.
using ExpectedEnd = std::variant<const Caller*, const flow::Exit*, WrittenAsMacro, KeepsState>;

/// Whether the program may be left there all the same: by a block that may be skipped or that nobody can
/// read, or by a called program that nobody knows.
[[nodiscard]] bool may_end_otherwise(const ProgramAnalysis& analysis, const flow::Exit& past_end);

/// Why the program must be left before the end that `past_end` is, the strongest reason; nothing where there
/// is none, or where the program may be left there all the same, though a known call outweighs a called
/// program that nobody knows. Where programs have sections, only a call is a reason: the manual does not say
/// what the end of a program is that nobody calls.
[[nodiscard]] std::optional<ExpectedEnd> find_expected_end(const ProgramAnalysis& analysis,
                                                           const flow::Exit& past_end);

} // namespace maclint::queries
