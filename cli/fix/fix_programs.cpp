//! Each round analyses the files as the round before has left them.
#include "cli/fix/fix_programs.hpp"

#include "cli/fix/edited_text.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::cli {
namespace {

/// A fix may uncover the next finding; more in a row than this undo one another.
constexpr int most_rounds = 20;

class Rounds {
  public:
    Rounds(const Snapshot& snapshot, FixesWanted wanted, const Analyse& analyse)
        : original_(snapshot)
        , now_(snapshot)
        , wanted_(wanted)
        , analyse_(analyse) {
        for (std::size_t i = 0; i < snapshot.files.size(); ++i) {
            const InputFile& input = snapshot.files[i].input;
            if (input.asked && !input.standard_input) may_change_.emplace(input.path, i);
        }
    }

    [[nodiscard]] FixedPrograms run() {
        Result result = analyse_(now_);
        for (int round = 0;; ++round) {
            std::vector<FileChange> changes = choose_fixes(
                result.findings, wanted_, [&](std::string_view path) { return may_change_.contains(path); });
            if (changes.empty()) break;
            if (round >= most_rounds)
                for (const FileChange& change : changes)
                    give_up(change.source->path(), "its fixes undo one another. Correct it by hand.");
            else
                for (const FileChange& change : changes) apply(change);
            result = analyse_(now_);
        }
        return {std::move(result), take_files(), std::move(notices_)};
    }

  private:
    void apply(const FileChange& change) {
        const std::string path = change.source->path();
        auto text = edited_text(*change.source, change.edits);
        if (const auto* refused = std::get_if<NotEditable>(&text))
            return give_up(path, refused->why + ", the encoding of the file. Correct it by hand.");
        auto [fixed, is_new] = fixed_.try_emplace(path, FixedFile{path, change.source, {}, 0});
        fixed->second.after = std::move(std::get<std::string>(text));
        fixed->second.findings += change.findings;
        now_.files[may_change_.find(path)->second].text =
            Source::from_bytes(path, fixed->second.after).read_as(change.source->stored_encoding());
    }

    void give_up(const std::string& path, const std::string& why) {
        const auto file = may_change_.find(path);
        now_.files[file->second].text = original_.files[file->second].text;
        may_change_.erase(file);
        fixed_.erase(path);
        notices_.push_back({NoticeKind::left_out, path, "it is left as it was: " + why});
    }

    std::vector<FixedFile> take_files() {
        std::vector<FixedFile> files;
        for (auto& [path, file] : fixed_)
            if (file.after != file.before->stored_bytes()) files.push_back(std::move(file));
        return files;
    }

    const Snapshot& original_;
    Snapshot now_;
    FixesWanted wanted_;
    const Analyse& analyse_;
    std::map<std::string, std::size_t, std::less<>> may_change_; ///< places in the snapshot, by path
    std::map<std::string, FixedFile> fixed_;
    std::vector<Notice> notices_;
};

} // namespace

FixedPrograms fix_programs(const Snapshot& snapshot, FixesWanted wanted, const Analyse& analyse) {
    return Rounds(snapshot, wanted, analyse).run();
}

} // namespace maclint::cli
