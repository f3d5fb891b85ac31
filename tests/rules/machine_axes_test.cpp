//! Words of axes that the machine lacks, and codes of options that are not fitted.
#include "analyzer/dialect/dialect.hpp"
#include "rules/words/code_pages.hpp"
#include "tests/support/linted.hpp"

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "2 B90. 009", of a machine with these axes.
std::vector<std::string> missing(const std::string& axes, const std::string& blocks,
                                 const std::string& control = "fanuc-30i") {
    cli::Overrides overrides;
    overrides.control = control;
    overrides.select = {"MAC124"};
    EXPECT_FALSE(overrides.machine.set_axes(axes));
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] :
         lint_texts({{"O1.nc", "O1(PLATE)\n" + blocks + "M30\n"}}, std::move(overrides)).findings)
        all.push_back(std::to_string(finding.source->position(finding.span.begin).line) + " " +
                      finding.arguments.front() + " " + std::string(finding.alarm));
    return all;
}

TEST(MissingAxis, IsToldWhereItsWordMovesOrReturns) {
    EXPECT_THAT(missing("XYZ", "G0 X1. B90.\n"), ElementsAre("2 B90. 009"));
    EXPECT_THAT(missing("XYZ", "G28 A0\n"), ElementsAre("2 A0 009"));
    EXPECT_THAT(missing("XYZ", "G0 A#1\n"), ElementsAre("2 A#1 009"));
    EXPECT_THAT(missing("XYZ", "G54 G0 X1. U5.\n"), ElementsAre("2 U5. 009"));
    EXPECT_THAT(missing("XYZ", "G0 B90.\nG0 B180.\nG0 A5.\n"), ElementsAre("2 B90. 009", "4 A5. 009"))
        << "each once";
    EXPECT_THAT(missing("XYZB", "G0 X1. B90.\n"), IsEmpty());
    EXPECT_THAT(missing("XYZ", "G0 A5.\n", "fanuc-16i"), ElementsAre("2 A5. "));
}

TEST(MissingAxis, IsNoneWhereTheLetterMeansSomethingElse) {
    EXPECT_THAT(missing("XYZ", "G65 P9001 A5. B6. C7.\n"), IsEmpty());
    EXPECT_THAT(missing("XYZ", "G10 L2 P1 A5.\n"), IsEmpty());
    EXPECT_THAT(missing("XYZ", "G1 X5. ,A30. F100\n"), IsEmpty());
    EXPECT_THAT(missing("XZ", "G1 X5. A30. C2. F0.1\n", "fanuc-30i-lathe"), IsEmpty());
    EXPECT_THAT(missing("XZ", "G1 X5. Y2. F0.1\n", "fanuc-30i-lathe"), ElementsAre("2 Y2. 009"));
    EXPECT_THAT(missing("XYZ", "G01 X5. U2.\n"), ElementsAre("2 U2. 009"));
}

TEST(Options, AreOnesOfWhichTheChaptersKnowTheCodes) {
    for (const char* const name : {"fanuc-16i", "fanuc-16i-lathe", "fanuc-30i", "fanuc-30i-lathe"}) {
        const ControlModel& control = *find_control(name);
        EXPECT_FALSE(control.options.empty());
        std::set<std::string_view> names;
        for (const ControlOption& option : control.options) {
            EXPECT_TRUE(names.insert(option.name).second) << option.name;
            if (!option.is_for(control.machine)) continue;
            std::istringstream codes{std::string(option.codes)};
            for (std::string code; codes >> code;)
                EXPECT_TRUE(has_page_anywhere("fanuc", code.front(), std::stod(code.substr(1))) ||
                            control.group_of(code.front(), std::stod(code.substr(1))))
                    << option.name << " " << code;
        }
    }
    EXPECT_TRUE(find_control("haas")->options.empty());
}

TEST(Options, ThatAreNotListedAreToldAsLacking) {
    cli::Overrides overrides;
    overrides.control = "fanuc-30i";
    overrides.select = {"MAC123"};
    EXPECT_FALSE(overrides.machine.add_option("scaling", *find_control("fanuc-30i")));
    const auto found = lint_texts(
        {{"O1.nc", "O1\nG51 X0 Y0 P2.\nG50\nG68 X0 Y0 R5.\nG69\nG54 G0 X1.\nM30\n"}}, std::move(overrides));
    EXPECT_THAT(codes(found), ElementsAre("MAC123", "MAC123"));
}

} // namespace
} // namespace maclint::test
