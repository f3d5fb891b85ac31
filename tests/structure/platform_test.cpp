//! What differs between systems stands in one folder; all else would work on Linux and fail on Windows.
#include "tests/structure/project_files.hpp"

#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

bool is_shipped(const std::string& path) {
    return path.starts_with("analyzer/") || path.starts_with("rules/") || path.starts_with("cli/");
}

/// Headers of one system; paths to text and back without platform::path_of and text_of, which on Windows
/// takes names for something else than UTF-8; functions of the standard library that know no links and no
/// long paths there; objects of a thread, unless they need no destructor; threads whose stack the system, or
/// the shell, decides on.
std::vector<std::string> bound_to_a_system(const std::vector<ProjectFile>& files) {
    static const std::regex bound(
        R"(#include <(unistd\.h|fcntl\.h|poll\.h|csignal|io\.h|windows\.h|sys/)|)"
        R"(\.string\(\)|\bfs::path\(|\bfilesystem::path\(|)"
        R"(\b(fs|filesystem)::(exists|is_\w+|canonical|weakly_canonical|equivalent|directory_iterator|)"
        R"(recursive_directory_iterator|read_symlink|status|file_size|rename)\(|)"
        R"(\bthread_local\b|\bstd::j?thread\b(?!::)|\bgmtime|\blocaltime|\bisatty|\bfopen\b|fstream\b)");
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        if (!is_shipped(file.path) || file.path.starts_with("analyzer/source/platform/")) continue;
        const std::string code = without_comments(file.text);
        for (std::sregex_iterator match(code.begin(), code.end(), bound), end; match != end; ++match) {
            const bool plain_pointer = match->str() == "thread_local" &&
                                       match->prefix().str().ends_with("static constinit ") &&
                                       match->suffix().str().find("* innermost") < 20;
            if (!plain_pointer) found.push_back(file.path + " has " + match->str());
        }
    }
    return found;
}

TEST(Systems, DifferInOneFolder) { EXPECT_THAT(bound_to_a_system(sources()), IsEmpty()); }

TEST(SystemsCheck, FindsWhatIsBoundToOne) {
    const std::vector<ProjectFile> files = {
        {"cli/a.cpp", "#include <unistd.h>\n"},
        {"cli/b.cpp", "const auto text = path.string();\n"},
        {"cli/c.cpp", "thread_local std::string kept; // .string()\n"},
        {"cli/d.cpp", "inline static constinit thread_local Asked* innermost = nullptr;\n"},
        {"analyzer/source/platform/posix/e.cpp", "#include <unistd.h>\n"},
        {"cli/f.cpp", "if (fs::exists(path)) return;\n"},
        {"cli/g.cpp", "return fs::weakly_canonical(path);\n"},
        {"cli/h.cpp", "std::thread worker(work); std::thread::hardware_concurrency();\n"}};
    EXPECT_THAT(bound_to_a_system(files),
                ElementsAre("cli/a.cpp has #include <unistd.h", "cli/b.cpp has .string()",
                            "cli/c.cpp has thread_local", "cli/f.cpp has fs::exists(",
                            "cli/g.cpp has fs::weakly_canonical(", "cli/h.cpp has std::thread"));
}

} // namespace
} // namespace maclint::structure
