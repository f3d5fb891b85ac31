//! Reading files whole, and saying what is wrong with those that cannot be read.
#include "analyzer/source/platform/input.hpp"
#include "analyzer/source/source.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <limits>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

namespace maclint {
namespace {

/// One byte less than an Offset can hold, so that lines and columns, which count from 1, fit as well.
constexpr std::size_t largest_file = std::numeric_limits<Offset>::max() - 1;
constexpr std::size_t growth_step = std::size_t{64} * 1024;

/// How long a pipe that was named, and standard input, may stay silent: others write to the latter, and
/// people type passwords before they do.
constexpr std::chrono::seconds patience_with_pipes{10};
constexpr std::chrono::seconds patience_with_input{60};

std::string quoted(const std::string& path) {
    return "'" + printable(to_utf8(path, detect_encoding(path))) + "'";
}

InputError cannot_read(const std::string& path, const std::string& why) {
    return {path, quoted(path) + " cannot be read: " + why};
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
    case EBUSY:
        return cannot_read(path, "another program has it open for itself. Close it there and try again.");
    case EIO:
        return cannot_read(path, "the disk or the network reports an error. Copy the file and try again.");
    default: return cannot_read(path, "the system says '" + std::generic_category().message(error) + "'.");
    }
}

InputError too_large(const std::string& path) {
    return cannot_read(path, "it has 4 GiB or more. Split the program or leave the file out.");
}

std::optional<InputError> refuse_kind(const std::string& path, platform::FileKind kind) {
    switch (kind) {
    case platform::FileKind::regular:
    case platform::FileKind::pipe: return std::nullopt;
    case platform::FileKind::folder:
        return cannot_read(path, "it is a folder. Name the files in it instead.");
    default: return cannot_read(path, "it is a device or a socket. Name a file instead.");
    }
}

InputError silent(const std::string& path, std::chrono::seconds patience) {
    return cannot_read(path, "nothing has come through this pipe for " + std::to_string(patience.count()) +
                                 " seconds. Start what writes to it, or leave it out.");
}

/// Reads to the end. The file may grow or shrink meanwhile: its size is only a hint. Without `patience` all
/// bytes are there at once.
std::variant<std::string, InputError> read_all(int descriptor, const std::string& path, std::size_t size_hint,
                                               std::optional<std::chrono::seconds> patience) {
    if (size_hint > largest_file) return too_large(path);
    std::string bytes(size_hint + 1, '\0');
    std::size_t filled = 0;
    while (true) {
        if (filled == bytes.size()) bytes.resize(std::max(bytes.size() + bytes.size() / 2, growth_step));
        if (patience && !platform::comes_in_time(descriptor, *patience)) return silent(path, *patience);
        const auto [count, error] = platform::read_some(descriptor, std::span(bytes).subspan(filled));
        if (error != 0) return system_refused(path, error);
        if (count == 0) break;
        filled += count;
        if (filled > largest_file) return too_large(path);
    }
    bytes.resize(filled);
    return bytes;
}

std::variant<Source, InputError> to_source(std::string path, std::variant<std::string, InputError> result) {
    if (auto* const error = std::get_if<InputError>(&result)) return std::move(*error);
    return Source::from_bytes(std::move(path), std::get<std::string>(std::move(result)));
}

} // namespace

std::variant<Source, InputError> Source::read_file(std::string path) {
    const platform::OpenFile file(path);
    if (file.error() != 0) return system_refused(path, file.error());
    if (auto refused = refuse_kind(path, file.kind())) return *std::move(refused);
    const bool waits = file.kind() == platform::FileKind::pipe;
    auto bytes = read_all(file.descriptor(), path, file.size(),
                          waits ? std::optional(patience_with_pipes) : std::nullopt);
    return to_source(std::move(path), std::move(bytes));
}

std::variant<Source, InputError> Source::read_standard_input(std::string path) {
    auto bytes = read_all(platform::standard_input, path, 0, patience_with_input);
    return to_source(std::move(path), std::move(bytes));
}

} // namespace maclint
