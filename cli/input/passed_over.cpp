//! Numbers in words.
#include "cli/input/passed_over.hpp"

#include "cli/text/shown.hpp"

namespace maclint::cli {

std::string text_of(const PassedOver& passed_over) {
    std::string text;
    const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
    if (passed_over.other_names == 1)
        add("1 file with another name passed over");
    else if (passed_over.other_names > 1)
        add(std::to_string(passed_over.other_names) + " files with other names passed over");
    if (passed_over.ignored_by_git > 0)
        add(counted(passed_over.ignored_by_git, "program") + " ignored by git");
    if (passed_over.links_out > 0) add(counted(passed_over.links_out, "link") + " to elsewhere not followed");
    return text;
}

} // namespace maclint::cli
