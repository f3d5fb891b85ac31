//! Where a cause stands, and when two are the same.
#include "rules/cause.hpp"

#include "analyzer/workspace/program_analysis.hpp"

namespace maclint {

Cause::Cause(const ProgramFile& of_file, Span of_text)
    : file(&of_file)
    , text(of_text) {}

Cause::Cause(const ProgramAnalysis& analysis, Span of_text)
    : file(&analysis.file())
    , program(&analysis.program())
    , text(of_text) {}

Cause::Cause(const ProgramAnalysis& analysis, EffectId of_effect)
    : Cause(analysis, analysis.program().effects[of_effect].span) {
    effect = of_effect;
}

Cause::Cause(const ProgramAnalysis& analysis, EffectId of_effect, ExpressionId of_expression)
    : Cause(analysis, of_effect) {
    expression = of_expression;
}

bool Cause::is_same(const Cause& other) const {
    if (file != other.file || program != other.program) return false;
    if (!effect && !other.effect) return text == other.text;
    if (effect != other.effect) return false;
    return !expression || !other.expression || expression == other.expression;
}

} // namespace maclint
