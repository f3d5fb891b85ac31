//! Which local variables callers may have set, where calls are there whose program only the control knows.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

WorkspaceFile file_with(std::string path, std::string text, bool may_be_computed) {
    const Dialect& dialect = *find_dialect("fanuc");
    auto source = std::make_shared<const Source>(Source::from_bytes(std::move(path), std::move(text)));
    return {std::make_shared<const ProgramFile>(
                dialect.read(std::move(source), *find_control(dialect.default_control), Extent::whole)),
            true, false, may_be_computed};
}

/// Whether it is known that no caller of O9001 sets #1: O1 calls O9002, which calls O9001.
bool is_set_by_no_caller(bool main_may_be_computed, bool between_may_be_computed) {
    std::vector<WorkspaceFile> files;
    files.push_back(file_with("1.nc", "O1\nM98P9002\nM30\n", main_may_be_computed));
    files.push_back(file_with("2.nc", "O9002\nM98P9001\nM99\n", between_may_be_computed));
    files.push_back(file_with("3.nc", "O9001\nIF[#500EQ1]GOTO2\n#1=1\nN2X#1\nM99\n", false));
    const auto workspace = Workspace::analyse(std::move(files), {.jobs = 1});
    const ProgramAnalysis& called = workspace->programs().back();
    return called.data().is_set_by_no_caller(called.control().formals.front());
}

TEST(CallersLocals, AreUnknownWhereAnUnknownCallMayMeanACallerFurtherUp) {
    EXPECT_TRUE(is_set_by_no_caller(false, false));
    EXPECT_FALSE(is_set_by_no_caller(false, true));
    EXPECT_TRUE(is_set_by_no_caller(true, false)); // a main program runs on its own
}

} // namespace
} // namespace maclint
