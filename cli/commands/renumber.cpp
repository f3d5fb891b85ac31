//! `maclint renumber`: numbers the blocks of programs anew, with all that names them.
#include "cli/renumber/renumber.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/commands/commands.hpp"
#include "cli/engine/read.hpp"
#include "cli/fix/edited_text.hpp"
#include "cli/fix/unified_difference.hpp"
#include "cli/fix/write_fixed.hpp"
#include "cli/input/discover.hpp"
#include "cli/renumber/connected_programs.hpp"
#include "cli/terminal.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace maclint::cli {
namespace {

/// What is wrong with a file, thrown to run_renumber.
struct NotRenumbered {
    Notice notice;
};

[[noreturn]] void leave(const std::string& path, const std::string& why) {
    throw NotRenumbered{{NoticeKind::unreadable, path, why + " The file is left as it was."}};
}

class Renumbering {
  public:
    Renumbering(const RenumberRequest& request, Settings& settings)
        : request_(request)
        , settings_(settings) {}

    FixedFile renumbered(const std::string& path) {
        if (platform::kind_of(platform::path_of(path)) == platform::FileKind::folder)
            throw NotRenumbered{{NoticeKind::unreadable, path, "is a folder. Name the programs in it."}};
        Discovered found = discover({path}, "", settings_);
        for (const Notice& notice : found.notices)
            if (notice.is_error()) throw NotRenumbered{notice};
        Discovered around = discover_context(found.files, {path}, settings_);
        const Snapshot asked = snapshot_of(std::move(found.files), settings_);
        if (asked.files.empty()) throw NotRenumbered{settings_.take_notices().front()};
        const SnapshotFile& file = asked.files.front();
        const ReadFile read = read_whole(file);
        if (read.notice) throw NotRenumbered{*read.notice};
        if (read.file == nullptr || read.not_nc) leave(path, "is no program that maclint knows.");
        const auto others =
            connected_programs(snapshot_of(std::move(around.files), settings_), *read.file, store_);
        return with_new_numbers(file, read, others);
    }

  private:
    ReadFile read_whole(const SnapshotFile& file) { return open_and_read(file, Extent::whole, store_); }

    FixedFile with_new_numbers(const SnapshotFile& file, const ReadFile& read,
                               const std::vector<std::shared_ptr<const ProgramFile>>& others) {
        const std::string& path = file.input.path;
        std::vector<const ProgramFile*> near;
        for (const auto& other : others) near.push_back(other.get());
        const NumberSpaces spaces = checked(path, number_spaces(*read.file, near));
        const auto& source = read.file->source;
        const std::vector<Edit> edits = checked(path, renumbering_of(source, spaces, request_.numbering));
        auto text = edited_text(*source, edits);
        if (const auto* refused = std::get_if<NotEditable>(&text)) leave(path, refused->why + ".");
        FixedFile fixed{path, source, std::get<std::string>(std::move(text)), edits.size()};
        require_same_jumps(file, fixed, spaces);
        return fixed;
    }

    template<class Value>
    static Value checked(const std::string& path, std::variant<Value, UnsafeNumber> made) {
        if (const auto* unsafe = std::get_if<UnsafeNumber>(&made)) leave(path, reason_of(*unsafe, path));
        return std::get<Value>(std::move(made));
    }

    /// Reads what was made as it will be read: each word must name the block that it named.
    void require_same_jumps(SnapshotFile file, const FixedFile& fixed, const NumberSpaces& before) {
        file.text = Source::from_bytes(fixed.path, fixed.after).read_as(fixed.before->stored_encoding());
        const ReadFile read = read_whole(file);
        const auto after = read.file == nullptr ? std::variant<NumberSpaces, UnsafeNumber>(NumberSpaces())
                                                : number_spaces(*read.file, {});
        const auto* spaces = std::get_if<NumberSpaces>(&after);
        if (spaces == nullptr || !name_the_same_blocks(before, *spaces))
            leave(fixed.path, "its jumps would not lead to the same blocks. Renumber by hand.");
    }

    const RenumberRequest& request_;
    Settings& settings_;
    ProgramStore store_{0};
};

std::string told(const std::vector<FixedFile>& files, bool would) {
    std::size_t numbers = 0;
    for (const FixedFile& file : files) numbers += file.findings;
    return std::string(would ? "Would change " : "Changed ") + counted(numbers, "number") + " in " +
           counted(files.size(), "file") + ".\n";
}

} // namespace

int run_renumber(const RenumberRequest& request) {
    Settings settings(request.overrides, own_folders(request.paths));
    Renumbering renumbering(request, settings);
    std::vector<FixedFile> files;
    int status = exit_clean;
    for (const std::string& path : request.paths) {
        try {
            FixedFile file = renumbering.renumbered(path);
            if (file.findings > 0) files.push_back(std::move(file));
        } catch (const NotRenumbered& refused) {
            print_notice(refused.notice);
            status = exit_error;
        }
    }
    if (!request.diff)
        for (const Notice& notice : write_fixed(files, request.paths)) {
            print_notice(notice);
            status = exit_error;
        }
    if (status == exit_clean || !files.empty()) print_aside(told(files, request.diff));
    return request.diff ? std::max(print_text(unified_difference(files)), status) : status;
}

} // namespace maclint::cli
