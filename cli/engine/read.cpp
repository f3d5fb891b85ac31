//! What a file is by its content and its settings.
#include "cli/engine/read.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/program/readable.hpp"
#include "analyzer/source/content.hpp"
#include "cli/input/own_report.hpp"
#include "cli/input/program_name.hpp"
#include "cli/input/size_limits.hpp"

#include <utility>

namespace maclint::cli {
namespace {

const ControlModel& control_of(const SnapshotFile& file, const Dialect& dialect, std::string_view shown) {
    if (const NamedControl* named = control_for(dialect, file.settings.controls)) return *named->control;
    const ControlModel* control = shown.empty() ? nullptr : find_control(shown);
    return control != nullptr && is_for(*control, dialect) ? *control
                                                           : *find_control(dialect.default_control);
}

/// Whoever names the dialect knows better what a text is, but no dialect reads an image.
bool is_no_text(const Source& source) {
    const Content content = classify(source.bytes());
    return content == Content::binary || content == Content::utf16;
}

Notice not_linted(const SnapshotFile& file, const std::string& reason, std::string_view cure) {
    return {NoticeKind::foreign, file.input.path, "this is not linted: " + reason + ". " + std::string(cure),
            reason.substr(0, reason.find(" (")), file.input.named};
}

Notice foreign(const SnapshotFile& file, const std::string& reason) {
    return not_linted(file, reason, "Name its dialect with --dialect if that is wrong.");
}

/// Naming a dialect would change nothing.
Notice no_program(const SnapshotFile& file, const std::string& reason) {
    return not_linted(file, reason, "Leave it out if it is no program.");
}

/// What nobody took for a program when it was named is no program that is broken.
bool reaches_the_control(const SnapshotFile& file) {
    return file.input.named && is_named_like_program(file.input.path);
}

/// An empty file is no error, but seldom what somebody meant.
Notice empty(const SnapshotFile& file) {
    return {NoticeKind::left_out, file.input.path,
            "this file is empty, so there is nothing to check. Fetch it again if it should hold a program."};
}

/// Why a text without marks of its dialect is likely in another language; nothing for all others.
std::optional<std::string> reason_for_doubt(const ProgramFile& file, const Dialect& dialect) {
    const Readable readable = count_readable(file);
    if (!readable.is_doubtful()) return std::nullopt;
    return std::to_string(readable.unreadable) + " of " + std::to_string(readable.blocks) +
           " blocks cannot be read as " + std::string(dialect.name);
}

/// A program file without programs, so that a finding has a place.
std::shared_ptr<const ProgramFile> empty_file(const ReadFile& read) {
    auto file = std::make_shared<ProgramFile>();
    file->source = read.source;
    file->control = read.control;
    return file;
}

} // namespace

std::variant<Source, Notice> open_file(const SnapshotFile& file) {
    if (file.text) return *file.text;
    const InputFile& input = file.input;
    const SizeLimit limit = program_limit(file.settings.max_file_size);
    auto result =
        input.standard_input ? read_standard_input(input.path, limit) : read_file(input.path, limit);
    if (auto* error = std::get_if<InputError>(&result))
        return Notice{NoticeKind::unreadable, std::move(error->path), std::move(error->message)};
    auto& source = std::get<Source>(result);
    const auto& configuration = file.settings.configuration;
    if (configuration && configuration->encoding && *configuration->encoding != source.stored_encoding())
        return source.read_as(*configuration->encoding);
    return std::move(source);
}

ReadFile read_source(const SnapshotFile& file, std::shared_ptr<const Source> source, Extent extent,
                     ProgramStore& store) {
    const Detection detection = detect_dialect(*source);
    const bool named = file.settings.dialect != nullptr;
    ReadFile read{.source = std::move(source),
                  .dialect = named ? file.settings.dialect : detection.dialect,
                  .dialect_reason = named ? file.settings.dialect_reason : detection.reason};
    const bool is_report = is_own_report(read.source->bytes());
    const std::string what_it_is = is_report ? "a report of maclint" : detection.reason;
    if (is_report && !reaches_the_control(file)) {
        read.dialect = nullptr;
        read.notice = no_program(file, what_it_is);
        return read;
    }
    if (!named && !detection.not_nc_text && is_named_like_other(file.input.path)) {
        read.dialect = nullptr;
        read.notice = foreign(file, "its name is none of an NC program");
        return read;
    }
    const bool not_nc = is_report || (detection.not_nc_text && (!named || is_no_text(*read.source)));
    if (not_nc && reaches_the_control(file)) {
        if (read.dialect == nullptr) read.dialect = &dialects().front();
        read.control = &control_of(file, *read.dialect, {});
        read.not_nc = what_it_is;
        read.file = empty_file(read);
        return read;
    }
    if (read.dialect == nullptr || not_nc) {
        read.dialect = nullptr;
        if (!not_nc || file.input.named || is_worth_a_note(file.input.path))
            read.notice = is_no_text(*read.source) ? no_program(file, detection.reason)
                                                   : foreign(file, detection.reason);
        return read;
    }
    if (is_empty(read.source->bytes())) read.notice = empty(file);
    const bool doubtful = !named && !detection.certain;
    read.extent = doubtful ? Extent::whole : extent;
    read.control = &control_of(file, *read.dialect, detection.control);
    if (read.control->name == detection.control) read.control_reason = detection.control_reason;
    if (read.extent == Extent::whole) {
        read.file = store.read(read.source, {read.dialect, read.control, file.settings.configuration});
        read.source = read.file->source; // that of the findings
    } else {
        read.file =
            std::make_shared<const ProgramFile>(read.dialect->read(read.source, *read.control, read.extent));
    }
    if (!doubtful) return read;
    if (auto reason = reason_for_doubt(*read.file, *read.dialect)) {
        read.notice = foreign(file, *reason);
        read.notice->what = "most blocks cannot be read";
        read.dialect_reason = *std::move(reason);
        read.dialect = nullptr;
        read.file = nullptr;
    }
    return read;
}

} // namespace maclint::cli
