//! A macro that does not show its machine is read for that of its callers.
#include "tests/support/in_repository.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class MacroOfCallers : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        folder.write("shop/O9300.nc", "O9300(STEP)\nG0X#24\nIF[#26EQ#0]GOTO99\nG1Z#26F#9\nM99\n");
    }

    /// The control that the macro, in which a label is missing, was read for.
    [[nodiscard]] std::string control() const {
        const Finished finished = run({"--format", "json", "--select", "MAC301", "shop"});
        const auto report = nlohmann::json::parse(finished.out);
        EXPECT_EQ(report["findings"].size(), 1U) << finished.err;
        return report["findings"].empty() ? "" : report["findings"][0].value("control", "");
    }
};

constexpr const char* turns =
    "O0300(SHAFT)\nT0101\nG50S2500\nG96S180M3\nG0X50.Z2.\nG65P9300X40.Z-30.F.2\nM30\n";
constexpr const char* mills = "O0301(PLATE)\nG17G90G54G0X0Y0\nG43H1Z5.\nG65P9300X40.Z-30.F200.\nM30\n";

TEST_F(MacroOfCallers, IsReadForTheLathe) {
    EXPECT_THAT(control(), Not(HasSubstr("lathe"))) << "nobody calls it";
    folder.write("shop/O0300.nc", turns);
    EXPECT_THAT(control(), HasSubstr("lathe"));
}

TEST_F(MacroOfCallers, IsReadForAMillWhereOneCallsIt) {
    folder.write("shop/O0300.nc", turns);
    folder.write("shop/O0301.nc", mills);
    EXPECT_THAT(control(), Not(HasSubstr("lathe")));
}

TEST_F(MacroOfCallers, IsReadAsTheConfigurationSays) {
    folder.write("shop/O0300.nc", turns);
    folder.write(".maclint.json", R"({"controls": {"Mill 1": {"model": "fanuc-30i", "machine": "mill"}},
                                      "files": [{"glob": "**", "control": "Mill 1"}]})");
    EXPECT_EQ(control(), "fanuc-30i");
}

} // namespace
} // namespace maclint::test
