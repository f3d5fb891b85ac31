//! Looks up arrays of other files by name.
#include "analyzer/queries/names/array_indices.hpp"

namespace maclint::queries {

std::vector<ArrayIndex> known_indices(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    std::vector<ArrayIndex> indices = program.array_indices;
    for (const ForeignElement& element : program.foreign_elements) {
        const ArrayDefinition* array = analysis.names_elsewhere().array(element.array);
        const auto values = program.indices_of(element);
        if (array == nullptr || array->sizes.size() != values.size()) continue;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (array->sizes[i]) indices.push_back({values[i], *array->sizes[i], element.span, {}});
    }
    return indices;
}

} // namespace maclint::queries
