//! fork and exec, with files in place of pipes: nothing can block.
#include "tests/support/process.hpp"

#include "tests/support/folder.hpp"

#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace maclint::test {
namespace {

void redirect(const std::string& path, int flags, int descriptor) {
    constexpr int readable = 0600;
    const int file = ::open(path.c_str(), flags, readable);
    if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(125);
}

} // namespace

Finished run_maclint(const std::string& folder, const std::vector<std::string>& arguments,
                     const std::string& input) {
    const TemporaryFolder streams;
    const std::string in = streams.write("in", input);
    const std::string out = streams.write("out", "");
    const std::string err = streams.write("err", "");
    std::string executable = MACLINT_EXECUTABLE;
    std::vector<std::string> words = arguments;
    std::vector<char*> pointers = {executable.data()};
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        redirect(in, O_RDONLY, STDIN_FILENO);
        redirect(out, O_WRONLY | O_TRUNC, STDOUT_FILENO);
        redirect(err, O_WRONLY | O_TRUNC, STDERR_FILENO);
        if (::chdir(folder.c_str()) != 0) ::_exit(125);
        ::execv(executable.c_str(), pointers.data());
        ::_exit(126);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, read_file(out), read_file(err)};
}

} // namespace maclint::test
