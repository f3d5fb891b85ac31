//! Settings are found one file after the other, reading and lowering go in parallel.
#include "cli/input/read.hpp"

#include "analyzer/workspace/parallel.hpp"

#include <utility>

namespace maclint::cli {
namespace {

std::variant<Source, InputError> open(const ReadFile& file) {
    auto result = file.input.standard_input ? Source::read_standard_input(file.input.path)
                                            : Source::read_file(file.input.path);
    if (const auto* source = std::get_if<Source>(&result)) {
        const auto& configuration = file.settings.configuration;
        if (configuration && configuration->encoding && *configuration->encoding != source->encoding())
            return source->read_as(*configuration->encoding);
    }
    return result;
}

const ControlModel& control_of(const ReadFile& file) {
    if (file.settings.control != nullptr) return *file.settings.control;
    return *find_control(file.dialect->default_control);
}

Notice foreign(const ReadFile& file, const std::string& reason) {
    return {NoticeKind::foreign, file.input.path,
            "this is not linted: " + reason + ". Name its dialect with --dialect if that is wrong."};
}

/// A program file without programs, so that a finding has a place.
std::shared_ptr<const ProgramFile> empty_file(std::shared_ptr<const Source> source,
                                              const ControlModel& control) {
    auto file = std::make_shared<ProgramFile>();
    file->source = std::move(source);
    file->control = &control;
    return file;
}

void read(ReadFile& file) {
    auto result = open(file);
    if (auto* error = std::get_if<InputError>(&result)) {
        file.notice = Notice{NoticeKind::unreadable, std::move(error->path), std::move(error->message)};
        return;
    }
    auto source = std::make_shared<const Source>(std::get<Source>(std::move(result)));
    const Detection detection = detect_dialect(*source);
    const bool told = file.settings.dialect != nullptr;
    file.dialect = told ? file.settings.dialect : detection.dialect;
    file.dialect_reason = told ? file.settings.dialect_reason : detection.reason;
    if (detection.not_nc_text && file.input.named) {
        if (file.dialect == nullptr) file.dialect = &dialects().front();
        file.not_nc = detection.reason;
        file.file = empty_file(std::move(source), control_of(file));
        return;
    }
    if (file.dialect == nullptr || detection.not_nc_text) {
        file.dialect = nullptr;
        file.notice = foreign(file, detection.reason);
        return;
    }
    file.file = std::make_shared<const ProgramFile>(file.dialect->read(std::move(source), control_of(file)));
}

} // namespace

std::vector<ReadFile> read_files(std::vector<InputFile> inputs, Settings& settings, unsigned jobs,
                                 Progress& progress) {
    std::vector<ReadFile> files;
    for (InputFile& input : inputs) {
        auto found = settings.for_file(input.path);
        if (!found) continue;
        ReadFile file;
        file.input = std::move(input);
        file.settings = *std::move(found);
        files.push_back(std::move(file));
    }
    progress.begin("reading", files.size());
    for_each_parallel(files.size(), jobs, [&](std::size_t i) {
        read(files[i]);
        progress.step();
    });
    return files;
}

} // namespace maclint::cli
