//! Looks up arrays of other files by name.
#include "analyzer/queries/names/array_indices.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

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

std::vector<OtherDimensions> other_dimensions(const ProgramAnalysis& analysis) {
    constexpr std::string_view of_one_value[] = {"BOOL", "INT", "REAL"};
    std::vector<OtherDimensions> found;
    for (const ForeignElement& element : analysis.program().foreign_elements) {
        const ArrayDefinition* variable = analysis.names_elsewhere().array(element.array);
        if (variable == nullptr || variable->type.empty()) continue; // files differ
        const std::size_t given = analysis.program().indices_of(element).size(),
                          wanted = variable->sizes.size();
        // An index more is a character of a text, or a part of a frame.
        const bool may_be_more = std::ranges::find(of_one_value, variable->type) == std::end(of_one_value);
        if (given != wanted && !(may_be_more && given > wanted)) found.push_back({element.span, wanted});
    }
    return found;
}

} // namespace maclint::queries
