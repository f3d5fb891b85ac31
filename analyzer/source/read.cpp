//! Reading files whole, and saying what is wrong with those that cannot be read.
#include "analyzer/source/read.hpp"

#include "analyzer/source/platform/input.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace maclint {
namespace {

constexpr SizeLimit any_source{largest_source, "Split the program or leave the file out."};
constexpr std::size_t growth_step = std::size_t{64} * 1024;

/// How long a file or a pipe, and standard input, may stay silent: others write to the latter, and people
/// type passwords before they do.
constexpr std::chrono::seconds patience_with_files{10};
constexpr std::chrono::seconds patience_with_input{60};

std::string quoted(const std::string& path) {
    return "'" + printable(to_utf8(path, detect_encoding(path))) + "'";
}

InputError cannot_read(const std::string& path, const std::string& why) {
    return {path, quoted(path) + " cannot be read: " + why};
}

InputError is_no_file(const std::string& path) {
    return cannot_read(path, "it is a device or a socket. Name a file instead.");
}

InputError system_refused(const std::string& path, int error) {
    switch (error) {
    case ENOENT:
    case ENOTDIR: return cannot_read(path, "there is no such file. Check the spelling and the folder.");
    case EACCES:
    case EPERM:
        return cannot_read(path,
                           "you have no permission. Ask its owner for read access or leave the file out.");
    case ELOOP:
        return cannot_read(path, "its symbolic links lead in a circle. Mend the link or leave it out.");
    case ENAMETOOLONG: return cannot_read(path, "the path is too long for the system. Shorten it.");
    case EMFILE:
    case ENFILE:
        return cannot_read(path, "too many files are open. Raise the limit (ulimit -n) or lower --jobs.");
    case ENXIO:
    case ENODEV: return is_no_file(path);
    case EBUSY:
        return cannot_read(path, "another program has it open for itself. Close it there and try again.");
    case EIO:
        return cannot_read(path, "the disk or the network reports an error. Copy the file and try again.");
    default: return cannot_read(path, "the system says '" + std::generic_category().message(error) + "'.");
    }
}

/// "1 GiB", "1500 MiB", "1000 bytes"
std::string in_words(std::uintmax_t bytes) {
    constexpr std::uintmax_t step = 1024;
    std::string_view unit = bytes == 1 ? " byte" : " bytes";
    for (const std::string_view larger : {" KiB", " MiB", " GiB"}) {
        if (bytes == 0 || bytes % step != 0) break;
        bytes /= step;
        unit = larger;
    }
    return std::to_string(bytes).append(unit);
}

InputError too_large(const std::string& path, const SizeLimit& limit) {
    std::string size = limit.bytes >= largest_source ? "it has 4 GiB or more. "
                                                     : "it is larger than " + in_words(limit.bytes) + ". ";
    return cannot_read(path, size.append(limit.cure));
}

std::optional<InputError> refuse_kind(const std::string& path, platform::FileKind kind) {
    switch (kind) {
    case platform::FileKind::regular:
    case platform::FileKind::pipe: return std::nullopt;
    case platform::FileKind::folder:
        return cannot_read(path, "it is a folder. Name the files in it instead.");
    default: return is_no_file(path);
    }
}

InputError silent(const std::string& path, platform::FileKind kind, std::chrono::seconds patience) {
    const std::string time = std::to_string(patience.count()) + " seconds. ";
    if (kind == platform::FileKind::regular)
        return cannot_read(path, "the system has given nothing of it for " + time +
                                     "Copy it to a disk of this computer, or leave it out.");
    return cannot_read(path, "nothing has come through this pipe for " + time +
                                 "Start what writes to it, or leave it out.");
}

/// Reads to the end. The file may grow or shrink meanwhile: its size is only a hint.
std::variant<std::string, InputError> read_all(platform::OpenFile& file, const std::string& path,
                                               const SizeLimit& limit, std::chrono::seconds patience) {
    const std::uintmax_t most = std::min(limit.bytes, largest_source);
    if (file.size() > most) return too_large(path, limit);
    std::string bytes(static_cast<std::size_t>(file.size()) + 1, '\0');
    std::size_t filled = 0;
    while (true) {
        if (filled == bytes.size())
            bytes.resize(std::min<std::uintmax_t>(std::max(filled + filled / 2, growth_step), most + 1));
        const auto portion = file.read_some(std::span(bytes).subspan(filled), patience);
        if (!portion) return silent(path, file.kind(), patience);
        if (portion->error != 0) return system_refused(path, portion->error);
        if (portion->count == 0) break;
        filled += portion->count;
        if (filled > most) return too_large(path, limit);
    }
    bytes.resize(filled);
    return bytes;
}

std::variant<Source, InputError> to_source(std::string path, std::variant<std::string, InputError> result) {
    if (auto* const error = std::get_if<InputError>(&result)) return std::move(*error);
    return Source::from_bytes(std::move(path), std::get<std::string>(std::move(result)));
}

std::variant<Source, InputError> read_open(platform::OpenFile& file, std::string path,
                                           const SizeLimit& limit) {
    if (file.error() != 0) return system_refused(path, file.error());
    if (auto refused = refuse_kind(path, file.kind())) return *std::move(refused);
    auto bytes = read_all(file, path, limit, patience_with_files);
    return to_source(std::move(path), std::move(bytes));
}

} // namespace

std::variant<Source, InputError> read_file(std::string path, const SizeLimit& limit) {
    platform::OpenFile file(path);
    return read_open(file, std::move(path), limit);
}

std::variant<Source, InputError> read_regular_file(std::string path, const SizeLimit& limit) {
    platform::OpenFile file(path);
    if (file.error() == 0 && file.kind() == platform::FileKind::pipe)
        return cannot_read(path, "it is a pipe. Name a file instead.");
    return read_open(file, std::move(path), limit);
}

std::string beginning_of_file(const std::string& path, std::size_t most) {
    platform::OpenFile file(path);
    if (file.error() != 0 || file.kind() != platform::FileKind::regular) return {};
    std::string bytes(most, '\0');
    std::size_t filled = 0;
    while (filled < most) {
        const auto portion = file.read_some(std::span(bytes).subspan(filled), patience_with_files);
        if (!portion || portion->error != 0 || portion->count == 0) break;
        filled += portion->count;
    }
    bytes.resize(filled);
    return bytes;
}

std::variant<Source, InputError> read_standard_input(std::string path, const SizeLimit& limit) {
    auto input = platform::OpenFile::standard_input();
    auto bytes = read_all(input, path, limit, patience_with_input);
    return to_source(std::move(path), std::move(bytes));
}

std::variant<Source, InputError> Source::read_file(std::string path) {
    return maclint::read_file(std::move(path), any_source);
}

std::variant<Source, InputError> Source::read_standard_input(std::string path) {
    return maclint::read_standard_input(std::move(path), any_source);
}

} // namespace maclint
