//! What every file of the project keeps to: no path of somebody's machine, and a first line that says what it
//! is.
#include "tests/structure/project_files.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;

/// Folders of build machines and of people. In two halves, so that this file does not hold them itself.
std::vector<std::string> machine_folders() {
    return {std::string("/ho") + "me/", std::string("/ro") + "ot/", std::string("/wo") + "rk/",
            std::string("/Us") + "ers/"};
}

/// A slash after one of these goes on with a relative path or a variable.
bool continues_a_path(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-.*})$~").find(c) != std::string_view::npos;
}

std::vector<std::string> machine_paths(const std::vector<ProjectFile>& files) {
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        for (const std::string& folder : machine_folders()) {
            for (auto at = file.text.find(folder); at != std::string::npos;
                 at = file.text.find(folder, at + 1)) {
                if (at == 0 || !continues_a_path(file.text[at - 1])) {
                    found.push_back(file.path + " holds " + file.text.substr(at, 40));
                    break;
                }
            }
        }
    }
    return found;
}

std::vector<std::string> without_brief(const std::vector<ProjectFile>& files) {
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        if (!file.text.starts_with("//! ")) found.push_back(file.path);
    }
    return found;
}

TEST(ProjectFiles, HoldNoPathOfABuildMachine) { EXPECT_THAT(machine_paths(all_files()), IsEmpty()); }

TEST(ProjectFiles, OpenWithALineThatSaysWhatLivesInThem) { EXPECT_THAT(without_brief(sources()), IsEmpty()); }

/// The folders of the layout in the README: "analyzer/", and "analyzer/flow/" for a line indented below it.
std::set<std::string> folders_of_layout(std::string_view readme) {
    static const std::regex row(R"(^( *)(\.?\w+/)( +(\w+/) )?)");
    std::set<std::string> found;
    std::string outer;
    std::istringstream lines(std::string(readme.substr(readme.find("## Layout"))));
    for (std::string line; std::getline(lines, line) && !line.starts_with("Dependencies");) {
        std::smatch part;
        if (!std::regex_search(line, part, row)) continue;
        const bool inner = part[1].length() != 0;
        if (!inner) outer = part[2].str();
        found.insert(inner ? outer + part[2].str() : outer);
        if (!inner && part[4].matched) found.insert(outer + part[4].str());
    }
    return found;
}

/// "analyzer/", "analyzer/flow/": the folders of the root and of the analyzer that hold files.
std::set<std::string> folders_of(const std::vector<ProjectFile>& files) {
    std::set<std::string> found;
    for (const ProjectFile& file : files) {
        const auto first = file.path.find('/');
        if (first == std::string::npos) continue;
        found.insert(file.path.substr(0, first + 1));
        const auto second = file.path.find('/', first + 1);
        if (second != std::string::npos && file.path.starts_with("analyzer/"))
            found.insert(file.path.substr(0, second + 1));
    }
    return found;
}

TEST(ProjectFiles, StandInTheFoldersThatTheReadmeNames) {
    const std::vector<ProjectFile> files = all_files();
    const auto readme = std::ranges::find(files, "README.md", &ProjectFile::path);
    ASSERT_NE(readme, files.end());
    const std::set<std::string> named = folders_of_layout(readme->text);
    EXPECT_THAT(named, IsSupersetOf({"analyzer/", "analyzer/source/", "analyzer/flow/", ".ci/"}));
    const std::set<std::string> there = folders_of(files);
    EXPECT_THAT(there, IsSupersetOf(named));
    for (const std::string& folder : there) {
        EXPECT_TRUE(!folder.starts_with("analyzer/") || named.contains(folder)) << folder;
    }
}

TEST(ProjectFilesCheck, FindsAnAbsolutePathButNotARelativeOne) {
    const std::string folder = machine_folders().front();
    const std::vector<ProjectFile> files = {{"a.json", "{\"path\": \"" + folder + "me/x\"}"},
                                            {"b.sh", "$root" + folder + "x"}};
    EXPECT_THAT(machine_paths(files), ElementsAre("a.json holds " + folder + "me/x\"}"));
}

} // namespace
} // namespace maclint::structure
