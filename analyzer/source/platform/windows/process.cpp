//! CreateProcess and two pipes, the second of which is read by a thread of its own.
#include "analyzer/source/platform/process.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/platform/windows/system.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <thread>

namespace maclint::platform {
namespace {

/// A word as the other program takes it out of its command line: backslashes count only in front of a quote.
std::wstring quoted(const std::wstring& word) {
    std::wstring out = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t c : word) {
        if (c == L'"') out.append(backslashes + 1, L'\\');
        backslashes = c == L'\\' ? backslashes + 1 : 0;
        out += c;
    }
    return out.append(backslashes, L'\\') + L'"';
}

std::wstring command_line(const std::vector<std::string>& words) {
    std::wstring line;
    for (const std::string& word : words) line += (line.empty() ? L"" : L" ") + quoted(wide(word));
    return line;
}

std::wstring variable(const wchar_t* name) {
    std::wstring value(GetEnvironmentVariableW(name, nullptr, 0), L'\0');
    value.resize(GetEnvironmentVariableW(name, value.data(), static_cast<DWORD>(value.size())));
    return value;
}

/// Where PATH has the program, by its absolute entries alone. CreateProcess would look beside maclint and in
/// the current folder first, and run what lies among the programs that are to be checked.
std::optional<std::filesystem::path> place_of(const std::string& program) {
    const std::wstring entries = variable(L"PATH");
    std::wstring entry;
    bool in_quotes = false; // a semicolon there is one of the name
    for (const wchar_t c : entries + L';') {
        if (c == L'"') {
            in_quotes = !in_quotes;
        } else if (c != L';' || in_quotes) {
            entry += c;
        } else {
            const auto place = std::filesystem::path(entry) / path_of(program + ".exe");
            if (place.is_absolute() && kind_of(place) == FileKind::regular) return place;
            entry.clear();
        }
    }
    return std::nullopt;
}

SECURITY_ATTRIBUTES inherited() { return {sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE}; }

/// Only the writing end goes to the other program.
struct Pipe {
    Pipe() {
        SECURITY_ATTRIBUTES attributes = inherited();
        HANDLE ends[2] = {INVALID_HANDLE_VALUE, INVALID_HANDLE_VALUE};
        if (CreatePipe(&ends[0], &ends[1], &attributes, 0) == 0) return;
        reader = ends[0];
        writer = ends[1];
        SetHandleInformation(reader, HANDLE_FLAG_INHERIT, 0);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close(reader);
        close(writer);
    }
    static void close(HANDLE& end) {
        if (end != INVALID_HANDLE_VALUE) CloseHandle(end);
        end = INVALID_HANDLE_VALUE;
    }

    HANDLE reader = INVALID_HANDLE_VALUE, writer = INVALID_HANDLE_VALUE;
};

void read_all(HANDLE reader, const std::function<void(std::string_view)>& take) {
    std::array<char, 65536> buffer{};
    DWORD got = 0;
    while (ReadFile(reader, buffer.data(), static_cast<DWORD>(buffer.size()), &got, nullptr) != 0 && got > 0)
        take({buffer.data(), got});
}

} // namespace

ProcessEnd run_process(const std::vector<std::string>& words,
                       const std::function<void(std::string_view part)>& take) {
    ProcessEnd end;
    const auto program = place_of(words.front());
    if (!program) return end;
    Pipe output;
    Pipe errors;
    SECURITY_ATTRIBUTES attributes = inherited();
    const Handle nothing(CreateFileW(L"NUL", GENERIC_READ, 0, &attributes, OPEN_EXISTING, 0, nullptr));
    if (output.reader == INVALID_HANDLE_VALUE || errors.reader == INVALID_HANDLE_VALUE) return end;
    STARTUPINFOW startup{};
    startup.cb = sizeof startup;
    startup.dwFlags = STARTF_USESTDHANDLES;
    startup.hStdInput = nothing.get();
    startup.hStdOutput = output.writer;
    startup.hStdError = errors.writer;
    PROCESS_INFORMATION made{};
    std::wstring line = command_line(words);
    if (CreateProcessW(program->c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW, nullptr,
                       nullptr, &startup, &made) == 0)
        return end;
    end.started = true;
    const Handle process(made.hProcess);
    const Handle thread(made.hThread);
    Pipe::close(output.writer);
    Pipe::close(errors.writer);
    std::thread second([&] {
        constexpr std::size_t most = 4096; // of what is wrong
        read_all(errors.reader, [&](std::string_view part) {
            end.errors += part.substr(0, most - std::min(most, end.errors.size()));
        });
    });
    read_all(output.reader, take);
    second.join();
    WaitForSingleObject(process.get(), INFINITE);
    DWORD status = 0;
    GetExitCodeProcess(process.get(), &status);
    end.status = static_cast<int>(status);
    return end;
}

} // namespace maclint::platform
