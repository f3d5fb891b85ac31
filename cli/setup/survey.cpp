//! Each file is read whole once, and let go.
#include "cli/setup/survey.hpp"

#include "analyzer/dialect/maker_rights.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/queries/words/enclosed_blocks.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/workspace/outline.hpp"
#include "cli/engine/read.hpp"
#include "cli/input/discover.hpp"
#include "rules/words/section_pages.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace maclint::cli {
namespace {

/// "M51" of a word that is an M code with a plain number.
std::optional<std::string> machine_function(const Word& word) {
    const auto* literal = std::get_if<Literal>(&word.value);
    constexpr double most = 99999;
    if (word.address != "M" || literal == nullptr || literal->value != std::floor(literal->value) ||
        literal->value < 0 || literal->value > most)
        return std::nullopt;
    return "M" + std::to_string(static_cast<int>(literal->value));
}

class Surveyor {
  public:
    explicit Surveyor(const std::string& folder)
        : folder_(platform::path_of(folder)) {}

    Survey look(const std::string& folder) {
        Overrides overrides;
        overrides.isolated = true;
        Settings settings(std::move(overrides));
        Discovered found = discover({folder}, "", settings);
        survey_.notices = std::move(found.notices);
        const Snapshot snapshot = snapshot_of(std::move(found.files), settings);
        for (const SnapshotFile& file : snapshot.files) look_at(file);
        match_calls();
        return std::move(survey_);
    }

  private:
    void look_at(const SnapshotFile& file) {
        auto opened = open_file(file);
        if (auto* notice = std::get_if<Notice>(&opened)) {
            survey_.notices.push_back(std::move(*notice));
            return;
        }
        auto source = std::make_shared<const Source>(std::get<Source>(std::move(opened)));
        const ReadFile read = read_source(file, std::move(source), Extent::whole, store_);
        const std::string path = below_folder(file.input.path);
        if (read.not_nc) return survey_.others.push_back({path, *read.not_nc});
        if (read.dialect == nullptr) return survey_.others.push_back({path, read.dialect_reason});
        const ControlModel& control = *read.file->control;
        const bool is_lathe = control.machine == Machine::lathe;
        survey_.programs.push_back({path,
                                    {std::string(read.dialect->name), read.control->name, is_lathe,
                                     is_lathe ? control.code_system : '\0'},
                                    read.control_reason});
        if (!programs_with_rights(*read.file).empty()) survey_.with_rights.push_back(path);
        note_codes(*read.file);
        outlines_.push_back(outline_of(*read.file));
    }

    [[nodiscard]] std::string below_folder(const std::string& path) const {
        return platform::text_of(platform::path_of(path).lexically_proximate(folder_));
    }

    /// M codes of no table, each once a file.
    void note_codes(const ProgramFile& file) {
        std::set<std::string> codes;
        for (const Program& program : file.programs)
            queries::for_each_block_in(program, program.span,
                                       [&](const BlockView&, std::span<const Word> words) {
                                           for (const Word& word : words)
                                               if (auto code = machine_function(word))
                                                   codes.insert(*std::move(code));
                                       });
        for (const std::string& code : codes)
            if (!is_known(file.control->language, code)) ++survey_.own_codes[code];
    }

    bool is_known(std::string_view language, const std::string& code) {
        const auto [entry, is_new] = known_.try_emplace({std::string(language), code}, false);
        if (is_new) entry->second = !pages_named(language, code).empty();
        return entry->second;
    }

    /// Calls with plain numbers alone: what is computed is known to the running program only.
    void match_calls() {
        std::set<std::int64_t> there, called;
        for (const FileOutline& file : outlines_)
            for (const ProgramOutline& program : file.programs) {
                if (program.number) there.insert(*program.number);
                for (const CallOutline& call : program.calls)
                    if (const auto* number = std::get_if<std::int64_t>(&call.program)) called.insert(*number);
            }
        for (const std::int64_t number : called)
            if (there.contains(number))
                ++survey_.called;
            else
                survey_.missing.insert("O" + std::to_string(number));
    }

    std::filesystem::path folder_;
    ProgramStore store_{0};
    Survey survey_;
    std::vector<FileOutline> outlines_;
    std::map<std::pair<std::string, std::string>, bool> known_;
};

} // namespace

Survey survey_of(const std::string& folder) { return Surveyor(folder).look(folder); }

} // namespace maclint::cli
