//! `maclint init`: a configuration to begin with.
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/commands/commands.hpp"
#include "cli/config/configuration.hpp"
#include "cli/setup/proposal.hpp"
#include "cli/terminal.hpp"
#include "cli/text/shown.hpp"
#include "cli/written_file.hpp"

namespace maclint::cli {
namespace {

int refuse_init(const std::string& path, const std::string& why) {
    print_notice({NoticeKind::unreadable, path, why});
    return exit_error;
}

} // namespace

int run_init(const InitRequest& request) {
    const auto folder = platform::path_of(request.folder);
    if (platform::kind_of(folder) != platform::FileKind::folder)
        return refuse_init(request.folder, "there is no such folder. Name the one that the programs lie in.");
    const auto file = folder / configuration_name;
    const std::string path = platform::text_of(file.lexically_normal());
    const bool is_free =
        platform::kind_of(file) == platform::FileKind::missing && !platform::link_target(file);
    if (!request.print && !is_free)
        return refuse_init(path, "is there already, and is left as it is. 'maclint init --print' shows what "
                                 "would be written.");
    const Survey survey = survey_of(request.folder);
    for (const Notice& notice : survey.notices) print_notice(notice);
    const std::string text = proposed_configuration(survey);
    if (request.print) return print_text(text);
    if (const auto why = write_file(path, text)) return refuse_init(path, "cannot be written: " + *why);
    return print_text(shown(path) + ": written, for " + counted(survey.programs.size(), "file") +
                      ". Read it, name your controls, and run maclint.\n");
}

} // namespace maclint::cli
