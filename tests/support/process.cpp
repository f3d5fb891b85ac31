//! fork and exec, with files in place of pipes: nothing can block.
#include "tests/support/process.hpp"

#include "tests/support/folder.hpp"

#include <array>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <grp.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace maclint::test {
namespace {

void redirect(const std::string& path, int flags, int descriptor) {
    constexpr int readable = 0600;
    const int file = ::open(path.c_str(), flags, readable);
    if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(125);
}

constexpr int no_start = 126;

enum class Privileges : std::uint8_t { kept, dropped };

/// For good, and with the groups: a member of root's group may read much.
bool drop_privileges() {
    constexpr uid_t nobody = 65534;
    return ::geteuid() != 0 ||
           (::setgroups(0, nullptr) == 0 && ::setgid(nobody) == 0 && ::setuid(nobody) == 0);
}

/// The first word is the executable.
Finished run(const std::string& folder, std::vector<std::string> words, const std::string& input,
             Privileges privileges) {
    const TemporaryFolder streams;
    const std::string in = streams.write("in", input);
    const std::string out = streams.write("out", "");
    const std::string err = streams.write("err", "");
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        redirect(in, O_RDONLY, STDIN_FILENO);
        redirect(out, O_WRONLY | O_TRUNC, STDOUT_FILENO);
        redirect(err, O_WRONLY | O_TRUNC, STDERR_FILENO);
        if (::chdir(folder.c_str()) != 0) ::_exit(125);
        if (privileges == Privileges::dropped && !drop_privileges()) ::_exit(no_start);
        ::execv(pointers.front(), pointers.data());
        ::_exit(no_start);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, read_file(out), read_file(err)};
}

/// The one that was built with the tests, unless the environment names another: maclint.exe under Wine.
std::string executable() {
    const char* other = std::getenv("MACLINT_EXECUTABLE");
    return other == nullptr ? MACLINT_EXECUTABLE : other;
}

std::vector<std::string> maclint_with(const std::vector<std::string>& arguments) {
    std::vector<std::string> words = {executable()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
}

} // namespace

Finished run_maclint_on_terminal(const std::string& folder, const std::vector<std::string>& arguments,
                                 unsigned short columns) {
    std::vector<std::string> words = maclint_with(arguments);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
    if (child < 0) throw std::runtime_error("no terminal");
    if (child == 0) {
        if (::chdir(folder.c_str()) != 0) ::_exit(125);
        ::execv(pointers.front(), pointers.data());
        ::_exit(no_start);
    }
    std::string out;
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = ::read(terminal, part.data(), part.size())) > 0;)
        out.append(part.data(), static_cast<std::size_t>(got));
    ::close(terminal);
    std::erase(out, '\r');
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out, ""};
}

Finished run_maclint(const std::string& folder, const std::vector<std::string>& arguments,
                     const std::string& input) {
    return run(folder, maclint_with(arguments), input, Privileges::kept);
}

Finished run_shell(const std::string& folder, const std::string& script) {
    return run(folder, {"/bin/sh", "-c", "maclint='" + executable() + "'\n" + script}, "", Privileges::kept);
}

std::optional<Finished> run_maclint_without_privileges(const std::string& folder,
                                                       const std::vector<std::string>& arguments) {
    Finished finished = run(folder, maclint_with(arguments), "", Privileges::dropped);
    if (finished.status == no_start) return std::nullopt;
    return finished;
}

} // namespace maclint::test
