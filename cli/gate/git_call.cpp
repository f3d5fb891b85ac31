//! Of the environment git gets what is the user's own, and of the settings those that close each door again.
#include "cli/gate/git_call.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "cli/text/shown.hpp"

#include <utility>

namespace maclint::cli {
namespace {

constexpr std::size_t longest_answer = std::size_t{1} << 24U;

platform::ProcessRequest request_for(const GitQuestion& question) {
    using platform::path_of;
    using platform::text_of;
    platform::ProcessRequest request{.words = {"git", "--no-pager", "-C", question.place.root}};
    // core.fsmonitor, core.hooksPath: nothing that is asked comes to them, and if it did. protocol.allow: for
    // what the folder's own settings leave open.
    for (const char* setting : {"core.fsmonitor=false", "core.hooksPath=/dev/null", "protocol.allow=never"}) {
        request.words.emplace_back("-c");
        request.words.emplace_back(setting);
    }
    request.words.insert(request.words.end(), question.words.begin(), question.words.end());
    request.input = question.input;
    request.left_out_prefix = "GIT_"; // a hook of another repository has its GIT_DIR there
    request.kept = {"GIT_CONFIG_NOSYSTEM"};
    // Where the user's own files are; git itself would look from the folder that is checked.
    request.paths = {"GIT_CONFIG_GLOBAL", "GIT_CONFIG_SYSTEM", "HOME", "XDG_CONFIG_HOME"};
    request.set = {
        "GIT_OPTIONAL_LOCKS=0",
        // Nothing is fetched: no protocol has that name, no alias can (git runs aliases as protocols, and one
        // of an empty name where this is empty). From 2.39.4 on, and 2.45.1, it is not even tried.
        "GIT_ALLOW_PROTOCOL=no_protocol",
        "GIT_NO_LAZY_FETCH=1",
        "GIT_TERMINAL_PROMPT=0",
        "GIT_CEILING_DIRECTORIES=" + text_of(path_of(question.place.root).parent_path()),
        "LC_ALL=C",
    };
    request.not_below = question.place.checked_roots;
    request.not_below.push_back(question.place.root);
    return request;
}

GitAnswer answer_to(const platform::ProcessRequest& request) {
    GitAnswer answer;
    answer.end = run_process(request, [&](std::string_view part) {
        answer.text += part;
        return answer.text.size() <= longest_answer;
    });
    if (answer.text.ends_with('\n')) answer.text.pop_back();
    return answer;
}

/// The first line of what git says.
std::string words_of(const platform::ProcessEnd& end) {
    using platform::EndedBy;
    if (end.by == EndedBy::silence) return "it has been silent for a minute";
    if (end.by == EndedBy::time) return "it has not come to an end in ten minutes";
    if (end.by == EndedBy::taker) return "it says too much";
    const std::string line = end.errors.substr(0, end.errors.find('\n'));
    return line.empty() ? "it ended with status " + std::to_string(end.status)
                        : "it says '" + shown(line) + "'";
}

} // namespace

platform::ProcessEnd ask_git(const GitQuestion& question, const platform::TakeOutput& take) {
    return run_process(request_for(question), take);
}

GitAnswer ask_git(const GitQuestion& question) { return answer_to(request_for(question)); }

GitAnswer list_settings(const GitPlace& place, const std::string& file) {
    auto request = request_for({.place = place, .words = {}});
    request.words = {"git", "config", "--file", file, "--no-includes", "--list", "-z"};
    request.set.emplace_back("GIT_DIR=/dev/null"); // it looks for no repository, and so at no other settings
    return answer_to(request);
}

Notice refusal_of_since(const std::string& message) { return {NoticeKind::configuration, "", message}; }

Notice git_failed(const std::string& root, const platform::ProcessEnd& end) {
    if (!end.passed_over.empty())
        return refusal_of_since("--since does not run '" + shown(end.passed_over) +
                                "', which a folder that is checked holds or leads to, and PATH has no other "
                                "git. Put one there, or leave --since out.");
    if (end.by == platform::EndedBy::nothing_started)
        return refusal_of_since(
            "--since runs git, and no git is found here. Install it, or leave --since out.");
    const bool is_of_another_owner = end.errors.find("dubious ownership") != std::string::npos ||
                                     end.errors.find("unsafe repository") != std::string::npos;
    return refusal_of_since("--since cannot ask git about '" + shown(root) + "': " + words_of(end) + ". " +
                            (is_of_another_owner ? "If you trust it, name it in git's safe.directory, or"
                                                 : "Mend the repository, or") +
                            " leave --since out.");
}

} // namespace maclint::cli
