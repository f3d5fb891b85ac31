//! Says in words why a report could not be written.
#include "cli/written_file.hpp"

#include "analyzer/source/platform/console.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"

#include <cerrno>
#include <system_error>

namespace maclint::cli {
namespace {

std::optional<std::string> refusal(int error) {
    if (error == 0) return std::nullopt;
    if (error == EFBIG)
        return "it would be larger than the system allows. Raise the limit (ulimit -f), or write it "
               "elsewhere.";
    return "the system says '" + std::generic_category().message(error) +
           "'. Check the folder, its permissions and the space that is left.";
}

} // namespace

std::optional<std::string> write_file(const std::string& path, std::string_view text) {
    if (!platform::names_open_file(path)) {
        switch (platform::kind_of(platform::path_of(path))) {
        case platform::FileKind::missing:
        case platform::FileKind::broken_link:
        case platform::FileKind::regular:
            return refusal(platform::replace_file(platform::written_path(path), text)); // replaces no link
        default: break;
        }
    }
    const int error = platform::write_in_place(path, text);
    if (error == ENXIO)
        return "nobody has read this pipe for " + std::to_string(platform::patience_with_readers.count()) +
               " seconds. Start what reads it, or leave it out.";
    return refusal(error);
}

std::optional<std::string> write_output(std::string_view text) {
    return refusal(platform::write(platform::Stream::output, text));
}

} // namespace maclint::cli
