//! Which call leads along a path.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/provoking_calls.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "tests/support/analysed.hpp"

#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

/// The line of the call that leaves #26 out and comes to the node of the M99 of O9001; 0: none.
std::uint32_t line_of_call(const std::string& calls, const std::string& macro) {
    const auto workspace = test::analyse_fanuc("O1\n" + calls + "M30\nO9001\n" + macro);
    const ProgramAnalysis& called = test::program(*workspace, "O9001");
    const auto path = queries::path_on_from(called, 0, called.graph().exits.back().node).path;
    if (!path) return 0;
    const SpaceId locals = called.control().formals.front().space;
    const Caller* call = queries::call_that_leaves_out(called, {locals, 26}, *path);
    return call == nullptr ? 0 : test::line_of_effect(workspace->programs()[call->program], call->effect);
}

TEST(ProvokingCall, LeavesTheArgumentOut) {
    EXPECT_EQ(line_of_call("G65P9001Z1.\nG65P9001X1.\n", "M99\n"), 3U);
    EXPECT_EQ(line_of_call("G65P9001Z1.\n", "M99\n"), 0U);
    EXPECT_EQ(line_of_call("M98P9001\n", "M99\n"), 0U); // it shares the locals
}

TEST(ProvokingCall, GoesThePath) {
    const std::string alarm_unless = "]GOTO5\n#3000=1\nN5M99\n";
    EXPECT_EQ(line_of_call("G65P9001A2.\nG65P9001A1.\n", "IF[#1EQ1" + alarm_unless), 3U);
    EXPECT_EQ(line_of_call("G65P9001\nG65P9001A1.\n", "IF[#1NE#0" + alarm_unless), 3U);
    EXPECT_EQ(line_of_call("G65P9001A2.\n", "IF[#1EQ1" + alarm_unless), 0U);
    EXPECT_EQ(line_of_call("G65P9001A#500\n", "IF[#1EQ1" + alarm_unless), 2U);
    EXPECT_EQ(line_of_call("G65P9001A2.\n", "#1=#500\nIF[#1EQ1" + alarm_unless), 2U);
}

} // namespace
} // namespace maclint
