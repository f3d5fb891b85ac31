//! Asks the workspace, which is told by whoever knows the folders.
#include "rules/words/unknown_code_finder.hpp"

#include <algorithm>

namespace maclint::rules {

bool has_macros_for_codes(const ProgramAnalysis& analysis) {
    return std::ranges::any_of(analysis.workspace().files(), [&](const WorkspaceFile& file) {
        return file.file.get() == &analysis.file() && file.has_macros_for_codes;
    });
}

} // namespace maclint::rules
