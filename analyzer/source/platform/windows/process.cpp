//! CreateProcess and three pipes, two of which are served by threads of their own.
#include "analyzer/source/platform/process.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/platform/windows/system.hpp"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
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

/// The system does not tell capitals from small letters.
int compare(std::wstring_view one, std::wstring_view other) {
    return CompareStringOrdinal(one.data(), static_cast<int>(one.size()), other.data(),
                                static_cast<int>(other.size()), TRUE) -
           CSTR_EQUAL;
}

bool is_below(const std::filesystem::path& path, const std::filesystem::path& folder) {
    return std::ranges::mismatch(folder, path, [](const auto& one, const auto& other) {
               return compare(one.native(), other.native()) == 0;
           }).in1 == folder.end();
}

/// Whether the way to a program leads through one of the folders: PATH as it is written, without its links,
/// or the program's own link.
bool leads_through(const std::filesystem::path& place, const std::vector<std::string>& folders) {
    std::error_code folder_error;
    std::error_code error;
    const std::array ways = {path_of(text_of(place.lexically_normal())),
                             path_of(text_of(real_path(place.parent_path(), folder_error))),
                             path_of(text_of(real_path(place, error)))};
    if (!folders.empty() && (folder_error || error)) return true;
    return std::ranges::any_of(folders, [&](const std::string& folder) {
        return std::ranges::any_of(ways, [&](const auto& way) { return is_below(way, path_of(folder)); });
    });
}

struct FoundProgram {
    std::optional<std::filesystem::path> place, passed_over;
};

/// Where PATH has the program, by its absolute entries alone. CreateProcess would look beside maclint and in
/// the current folder first, and run what lies among the programs that are to be checked.
FoundProgram find_program(const std::string& program, const std::vector<std::string>& not_below) {
    const std::wstring entries = variable(L"PATH");
    FoundProgram found;
    std::wstring entry;
    bool in_quotes = false; // a semicolon there is one of the name
    for (const wchar_t c : entries + L';') {
        if (c == L'"') {
            in_quotes = !in_quotes;
        } else if (c != L';' || in_quotes) {
            entry += c;
        } else {
            const auto place = std::filesystem::path(entry) / path_of(program + ".exe");
            entry.clear();
            if (!place.is_absolute() || kind_of(place) != FileKind::regular) continue;
            auto& kept = leads_through(place, not_below) ? found.passed_over : found.place;
            if (!kept) kept = place;
            if (found.place) break;
        }
    }
    return found;
}

/// "NAME" of "NAME=value"; names such as "=C:" are the system's own.
std::wstring_view name_of(std::wstring_view variable) { return variable.substr(0, variable.find(L'=', 1)); }

/// An empty path stays empty: it names nothing.
std::wstring with_absolute_path(const std::wstring& variable) {
    const std::filesystem::path path =
        variable.substr(std::min(variable.size(), name_of(variable).size() + 1));
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    if (path.empty() || error) return variable;
    return std::wstring(name_of(variable)) + L"=" + absolute.wstring();
}

/// As the system wants it: sorted, each with a null behind it, and another at the end.
std::wstring environment_for(const ProcessRequest& request) {
    std::vector<std::wstring> variables;
    for (const std::string& text : request.set) variables.push_back(wide(text));
    const auto is_set = [&](std::wstring_view name) {
        return std::ranges::any_of(
            request.set, [&](const std::string& other) { return compare(name_of(wide(other)), name) == 0; });
    };
    const std::wstring prefix = wide(request.left_out_prefix);
    const auto is_left_out = [&](std::wstring_view name) {
        return !prefix.empty() && compare(name.substr(0, prefix.size()), prefix) == 0 &&
               std::ranges::none_of(request.kept,
                                    [&](const std::string& kept) { return compare(wide(kept), name) == 0; });
    };
    const auto is_path = [&](std::wstring_view name) {
        return std::ranges::any_of(request.paths,
                                   [&](const std::string& path) { return compare(wide(path), name) == 0; });
    };
    if (wchar_t* const all = GetEnvironmentStringsW(); all != nullptr) {
        for (const wchar_t* at = all; *at != L'\0'; at += std::wstring_view(at).size() + 1)
            if (is_set(name_of(at))) {
                continue;
            } else if (is_path(name_of(at))) {
                variables.push_back(with_absolute_path(at));
            } else if (!is_left_out(name_of(at))) {
                variables.emplace_back(at);
            }
        FreeEnvironmentStringsW(all);
    }
    std::ranges::sort(variables, [](const std::wstring& one, const std::wstring& other) {
        return compare(name_of(one), name_of(other)) < 0;
    });
    std::wstring block;
    for (const std::wstring& one : variables) block.append(one).push_back(L'\0');
    return block + L'\0';
}

enum class Inherited : std::uint8_t { reader, writer };

/// One end goes to the other program.
struct Pipe {
    explicit Pipe(Inherited inherited) {
        SECURITY_ATTRIBUTES attributes{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
        HANDLE ends[2] = {INVALID_HANDLE_VALUE, INVALID_HANDLE_VALUE};
        if (CreatePipe(&ends[0], &ends[1], &attributes, 0) == 0) return;
        reader = ends[0];
        writer = ends[1];
        SetHandleInformation(inherited == Inherited::reader ? writer : reader, HANDLE_FLAG_INHERIT, 0);
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

struct Pipes {
    Pipe input{Inherited::reader}, output{Inherited::writer}, errors{Inherited::writer};

    [[nodiscard]] bool are_open() const {
        return input.reader != INVALID_HANDLE_VALUE && output.reader != INVALID_HANDLE_VALUE &&
               errors.reader != INVALID_HANDLE_VALUE;
    }
};

/// The program and all that it starts: git.exe of a PATH is one that starts another. Where the system makes
/// no job, the program alone.
class Family {
  public:
    Family()
        : job_(CreateJobObjectW(nullptr, nullptr)) {}
    Family(const Family&) = delete;
    Family& operator=(const Family&) = delete;
    ~Family() {
        if (job_ != nullptr) CloseHandle(job_);
    }

    void take_in(HANDLE process) {
        process_ = process;
        if (job_ != nullptr && AssignProcessToJobObject(job_, process) != 0) return;
        if (job_ != nullptr) CloseHandle(job_);
        job_ = nullptr;
    }
    void end() const {
        constexpr UINT status = 127;
        if (job_ != nullptr) {
            TerminateJobObject(job_, status);
        } else {
            TerminateProcess(process_, status);
        }
    }

  private:
    HANDLE job_;
    HANDLE process_ = nullptr;
};

/// Ends a family that is silent or runs for too long; what comes and goes is told to it.
class Watch {
  public:
    Watch(const Family& family, const ProcessRequest& request)
        : thread_([this, &family, patience = request.patience, longest = request.longest] {
            const auto latest = std::chrono::steady_clock::now() + longest;
            std::unique_lock lock(mutex_);
            while (!is_over_) {
                const std::uint64_t before = parts_;
                const auto end_of_patience = std::chrono::steady_clock::now() + patience;
                changed_.wait_until(lock, std::min(latest, end_of_patience), [this] { return is_over_; });
                const bool is_late = std::chrono::steady_clock::now() >= latest;
                if (is_over_ || (parts_ != before && !is_late)) continue;
                ended_by_ = is_late ? EndedBy::time : EndedBy::silence;
                family.end();
                return;
            }
        }) {}
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    ~Watch() { stop(); }

    void count_part() {
        const std::scoped_lock lock(mutex_);
        ++parts_;
    }
    /// What ended the family.
    EndedBy stop() {
        {
            const std::scoped_lock lock(mutex_);
            is_over_ = true;
        }
        changed_.notify_all();
        if (thread_.joinable()) thread_.join();
        return ended_by_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t parts_ = 0;
    bool is_over_ = false;
    EndedBy ended_by_ = EndedBy::itself;
    std::thread thread_; // last: it uses the others
};

/// False: who takes the parts wanted no more.
bool read_all(HANDLE reader, Watch& watch, const TakeOutput& take) {
    std::array<char, 65536> buffer{};
    DWORD got = 0;
    while (ReadFile(reader, buffer.data(), static_cast<DWORD>(buffer.size()), &got, nullptr) != 0) {
        watch.count_part();
        if (got > 0 && !take({buffer.data(), got})) return false;
    }
    return true;
}

void write_parts(HANDLE& writer, Watch& watch, std::string_view rest) {
    constexpr std::size_t most = 65536;
    DWORD written = 0;
    while (!rest.empty() && WriteFile(writer, rest.data(), static_cast<DWORD>(std::min(most, rest.size())),
                                      &written, nullptr) != 0) {
        watch.count_part();
        rest.remove_prefix(written);
    }
    Pipe::close(writer);
}

/// Suspended, so that it starts nothing before it belongs to its family.
std::optional<PROCESS_INFORMATION> create(const std::filesystem::path& program, const ProcessRequest& request,
                                          const Pipes& pipes) {
    STARTUPINFOW startup{};
    startup.cb = sizeof startup;
    startup.dwFlags = STARTF_USESTDHANDLES;
    startup.hStdInput = pipes.input.reader;
    startup.hStdOutput = pipes.output.writer;
    startup.hStdError = pipes.errors.writer;
    PROCESS_INFORMATION made{};
    std::wstring line = command_line(request.words);
    std::wstring environment = environment_for(request);
    constexpr DWORD flags = CREATE_NO_WINDOW | CREATE_SUSPENDED | CREATE_UNICODE_ENVIRONMENT;
    if (CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, flags, environment.data(),
                       nullptr, &startup, &made) == 0)
        return std::nullopt;
    return made;
}

} // namespace

ProcessEnd run_process(const ProcessRequest& request, const TakeOutput& take) {
    ProcessEnd end;
    const auto program = find_program(request.words.front(), request.not_below);
    if (!program.place && program.passed_over) end.passed_over = text_of(*program.passed_over);
    if (!program.place) return end;
    Pipes pipes;
    if (!pipes.are_open()) return end;
    const auto made = create(*program.place, request, pipes);
    if (!made) return end;
    const Handle process(made->hProcess);
    const Handle thread(made->hThread);
    Family family;
    family.take_in(process.get());
    ResumeThread(thread.get());
    Pipe::close(pipes.input.reader);
    Pipe::close(pipes.output.writer);
    Pipe::close(pipes.errors.writer);
    Watch watch(family, request);
    std::thread writing([&] { write_parts(pipes.input.writer, watch, request.input); });
    std::thread complaining([&] {
        constexpr std::size_t most = 4096; // of what is wrong
        read_all(pipes.errors.reader, watch, [&](std::string_view part) {
            end.errors += part.substr(0, most - std::min(most, end.errors.size()));
            return true;
        });
    });
    const bool all_taken = read_all(pipes.output.reader, watch, take);
    if (!all_taken) family.end();
    complaining.join();
    writing.join();
    WaitForSingleObject(process.get(), INFINITE);
    const EndedBy ended_by = watch.stop();
    end.by = all_taken ? ended_by : EndedBy::taker;
    DWORD status = 0;
    GetExitCodeProcess(process.get(), &status);
    end.status = static_cast<int>(status);
    return end;
}

} // namespace maclint::platform
