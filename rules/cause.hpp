//! What a finding is about, apart from where it is shown.
#pragma once

#include "analyzer/program/ids.hpp"
#include "analyzer/source/span.hpp"

#include <optional>

namespace maclint {

class Program;
class ProgramAnalysis;
struct ProgramFile;

/// What a finding is about. Of two rules that speak of one cause only one is heard, see Rule::yields_to.
struct Cause {
    /// Text that is no part of a program: a comment, what could not be read.
    Cause(const ProgramFile& of_file, Span of_text);
    /// Text of a program that does nothing by itself: a word, a block number, what is missing after a block.
    Cause(const ProgramAnalysis& analysis, Span of_text);
    Cause(const ProgramAnalysis& analysis, EffectId of_effect);
    Cause(const ProgramAnalysis& analysis, EffectId of_effect, ExpressionId of_expression);
    /// What a fact of data flow is about.
    template<class Fact>
    requires requires(const Fact& fact) { fact.effect; }
    Cause(const ProgramAnalysis& analysis, const Fact& fact)
        : Cause(analysis, fact.effect) {
        if constexpr (requires { fact.expression; }) expression = fact.expression;
    }

    /// Whether both are about the same: an effect and an expression in it are.
    [[nodiscard]] bool is_same(const Cause& other) const;

    const ProgramFile* file;
    const Program* program = nullptr; ///< nullptr: text of the file. Both are for comparing only: a finding
                                      ///< outlives them
    std::optional<EffectId> effect;   ///< empty: only `text` tells
    std::optional<ExpressionId> expression;
    Span text = {};
};

} // namespace maclint
