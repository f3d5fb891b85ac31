//! Asks the workspace, the files of definitions and the configuration.
#include "analyzer/queries/names/unknown_names.hpp"

#include <algorithm>

namespace maclint::queries {

bool is_misspelt(const ProgramAnalysis& analysis, const UnknownName& name) {
    return !name.meant.empty() && !analysis.names_elsewhere().contain(name.name) &&
           analysis.workspace().count_named(name.name) == 0;
}

bool is_undefined(const ProgramAnalysis& analysis, const UnknownName& name) {
    const NamesElsewhere& elsewhere = analysis.names_elsewhere();
    return name.meant.empty() && elsewhere.are_all && !elsewhere.contain(name.name);
}

bool is_misspelt_at(const ProgramAnalysis& analysis, Span span) {
    return std::ranges::any_of(analysis.program().unknown_names, [&](const UnknownName& name) {
        return name.span.begin == span.begin && is_misspelt(analysis, name);
    });
}

} // namespace maclint::queries
