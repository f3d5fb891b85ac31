//! Runs the executable in a folder of its own, which looks like a repository: nothing above it is searched.
#pragma once

#include "tests/support/folder.hpp"
#include "tests/support/process.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace maclint::test {

constexpr std::string_view without_defect = "%\nO1000 (GOOD)\nG0 X1.\nM30\n%\n";
/// A Fanuc program with MAC301 on line 4.
constexpr std::string_view with_defect = "%\nO1001 (BAD)\nG0 X1.\nGOTO 99\nM30\n%\n";

class InRepository : public testing::Test {
  protected:
    void SetUp() override { folder.write(".git/HEAD", ""); }

    [[nodiscard]] Finished run(const std::vector<std::string>& arguments,
                               const std::string& input = "") const {
        return run_maclint(folder.path().string(), arguments, input);
    }
    [[nodiscard]] Finished shell(const std::string& script) const {
        return run_shell(folder.path().string(), script);
    }

    TemporaryFolder folder;
};

} // namespace maclint::test
