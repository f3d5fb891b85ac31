//! Looks once more at each file just before it is written.
#include "cli/fix/write_fixed.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/input/checked_trees.hpp"
#include "cli/written_file.hpp"

#include <optional>
#include <utility>
#include <variant>

namespace maclint::cli {
namespace {

std::optional<std::string> write(const FixedFile& file, const CheckedTrees& trees) {
    if (const auto objection = trees.objection_to_writing(file.path))
        return "it would be written " + *objection + ". Check the folder that it lies in.";
    if (platform::kind_of(platform::path_of(file.path)) != platform::FileKind::regular)
        return "only a file can be fixed. Use --diff.";
    const auto now = Source::read_file(file.path);
    const auto* source = std::get_if<Source>(&now);
    if (source == nullptr || source->stored_bytes() != file.before->stored_bytes())
        return "it has changed since it was read. Run maclint again.";
    return write_file(file.path, file.after);
}

} // namespace

std::vector<Notice> write_fixed(std::vector<FixedFile>& files, const std::vector<std::string>& paths) {
    const CheckedTrees trees(paths);
    std::vector<Notice> notices;
    std::erase_if(files, [&](const FixedFile& file) {
        const auto why = write(file, trees);
        if (why) notices.push_back({NoticeKind::unreadable, file.path, "it is not fixed: " + *why});
        return why.has_value();
    });
    return notices;
}

} // namespace maclint::cli
