//! Numbers in words.
#include "cli/input/passed_over.hpp"

#include "cli/suggest.hpp"

namespace maclint::cli {

std::string text_of(const PassedOver& passed_over) {
    std::string text;
    if (passed_over.other_names == 1)
        text = "1 file with another name passed over";
    else if (passed_over.other_names > 1)
        text = std::to_string(passed_over.other_names) + " files with other names passed over";
    if (passed_over.ignored_by_git > 0)
        text +=
            (text.empty() ? "" : ", ") + counted(passed_over.ignored_by_git, "program") + " ignored by git";
    return text;
}

} // namespace maclint::cli
