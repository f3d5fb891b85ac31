//! What every file of the project keeps to: no path of somebody's machine, and a first line that says what it
//! is.
#include "tests/structure/project_files.hpp"

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Folders of build machines and of people. In two halves, so that this file does not hold them itself.
std::vector<std::string> machine_folders() {
    return {std::string("/ho") + "me/", std::string("/ro") + "ot/", std::string("/wo") + "rk/",
            std::string("/Us") + "ers/"};
}

/// A slash behind one of these goes on with a relative path or a variable.
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

TEST(ProjectFilesCheck, FindsAnAbsolutePathButNotARelativeOne) {
    const std::string folder = machine_folders().front();
    const std::vector<ProjectFile> files = {{"a.json", "{\"path\": \"" + folder + "me/x\"}"},
                                            {"b.sh", "$root" + folder + "x"}};
    EXPECT_THAT(machine_paths(files), ElementsAre("a.json holds " + folder + "me/x\"}"));
}

} // namespace
} // namespace maclint::structure
