//! Settings are found one file after the other, reading and lowering go in parallel.
#include "cli/input/read.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/program/readable.hpp"
#include "analyzer/source/content.hpp"
#include "analyzer/workspace/parallel.hpp"

#include <utility>

namespace maclint::cli {
namespace {

std::variant<Source, InputError> open(const InputFile& input, const FileSettings& settings) {
    auto result =
        input.standard_input ? Source::read_standard_input(input.path) : Source::read_file(input.path);
    if (const auto* source = std::get_if<Source>(&result)) {
        const auto& configuration = settings.configuration;
        if (configuration && configuration->encoding && *configuration->encoding != source->encoding())
            return source->read_as(*configuration->encoding);
    }
    return result;
}

const ControlModel& control_of(const ReadFile& file) {
    if (const NamedControl* named = control_for(*file.dialect, file.settings.controls))
        return *named->control;
    return *find_control(file.dialect->default_control);
}

/// Whoever names the dialect knows better what a text is, but no dialect reads an image.
bool is_no_text(const Source& source) {
    const Content content = classify(source.bytes());
    return content == Content::binary || content == Content::utf16;
}

Notice foreign(const ReadFile& file, const std::string& reason) {
    return {NoticeKind::foreign, file.input.path,
            "this is not linted: " + reason + ". Name its dialect with --dialect if that is wrong."};
}

/// An empty file is no error, but seldom what somebody meant.
Notice empty(const ReadFile& file) {
    return {NoticeKind::left_out, file.input.path,
            "this file is empty, so there is nothing to check. Fetch it again if it should hold a program."};
}

/// Why a text without marks of its dialect is likely in another language; nothing for all others.
std::optional<std::string> find_vacancy_origin(const ReadFile& file, const Detection& detection) {
    if (file.settings.dialect != nullptr || detection.certain) return std::nullopt;
    const Readable readable = count_readable(*file.file);
    if (!readable.is_doubtful()) return std::nullopt;
    return std::to_string(readable.unreadable) + " of " + std::to_string(readable.blocks) +
           " blocks cannot be read as " + std::string(file.dialect->name);
}

/// A program file without programs, so that a finding has a place.
std::shared_ptr<const ProgramFile> empty_file(std::shared_ptr<const Source> source,
                                              const ControlModel& control) {
    auto file = std::make_shared<ProgramFile>();
    file->source = std::move(source);
    file->control = &control;
    return file;
}

ReadFile read(InputFile input, FileSettings settings) {
    auto result = open(input, settings);
    if (auto* source = std::get_if<Source>(&result))
        return read_source(std::move(input), std::move(settings), std::move(*source));
    auto& error = std::get<InputError>(result);
    ReadFile file;
    file.input = std::move(input);
    file.settings = std::move(settings);
    file.notice = Notice{NoticeKind::unreadable, std::move(error.path), std::move(error.message)};
    return file;
}

} // namespace

ReadFile read_source(InputFile input, FileSettings settings, Source bytes) {
    ReadFile file;
    file.input = std::move(input);
    file.settings = std::move(settings);
    auto source = std::make_shared<const Source>(std::move(bytes));
    const Detection detection = detect_dialect(*source);
    const bool reported = file.settings.dialect != nullptr;
    file.dialect = reported ? file.settings.dialect : detection.dialect;
    file.dialect_reason = reported ? file.settings.dialect_reason : detection.reason;
    const bool not_nc = detection.not_nc_text && (!reported || is_no_text(*source));
    if (not_nc && file.input.named) {
        if (file.dialect == nullptr) file.dialect = &dialects().front();
        file.not_nc = detection.reason;
        file.file = empty_file(std::move(source), control_of(file));
        return file;
    }
    if (file.dialect == nullptr || not_nc) {
        file.dialect = nullptr;
        if (!not_nc || is_worth_a_note(file.input.path)) file.notice = foreign(file, detection.reason);
        return file;
    }
    if (classify(source->bytes()) == Content::empty) file.notice = empty(file);
    file.file = std::make_shared<const ProgramFile>(file.dialect->read(std::move(source), control_of(file)));
    if (auto vacancy_origin = find_vacancy_origin(file, detection)) {
        file.notice = foreign(file, *vacancy_origin);
        file.dialect_reason = *std::move(vacancy_origin);
        file.dialect = nullptr;
        file.file = nullptr;
    }
    return file;
}

std::vector<ReadFile> read_files(std::vector<InputFile> inputs, Settings& settings, unsigned jobs,
                                 Progress& progress) {
    std::vector<InputFile> known;
    std::vector<FileSettings> known_settings;
    for (InputFile& input : inputs) {
        auto found = settings.for_file(input.path);
        if (!found) continue;
        known.push_back(std::move(input));
        known_settings.push_back(*std::move(found));
    }
    std::vector<ReadFile> files(known.size());
    progress.begin("reading", files.size());
    for_each_parallel(files.size(), jobs, [&](std::size_t i) {
        files[i] = read(std::move(known[i]), std::move(known_settings[i]));
        progress.step();
    });
    return files;
}

} // namespace maclint::cli
