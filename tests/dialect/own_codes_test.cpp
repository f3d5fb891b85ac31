//! Codes that parameters of the machine make call programs.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/workspace/outline.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// By letter and number, as ControlModel wants them.
const ControlModel& machine() {
    static const ControlModel control = [] {
        ControlModel own = *find_control("fanuc-16i");
        own.own_codes = {{'G', 81, 9010}, {'G', 310, 0}, {'M', 50, 9001}, {'M', 90, 9020}};
        return own;
    }();
    return control;
}

ProgramFile read(const std::string& text, const ControlModel& control, Extent extent) {
    auto source = std::make_shared<const Source>(Source::from_bytes("O1.nc", text));
    return find_dialect("fanuc")->read(std::move(source), control, extent);
}

/// "G65 macro call of 9010 with A B x2", one a call.
std::vector<std::string> calls_in(const std::string& text, const ControlModel& control) {
    const ProgramFile file = read(text, control, Extent::whole);
    std::vector<std::string> calls;
    for (const Program& program : file.programs)
        for (const Effect& effect : program.effects) {
            const auto* call = std::get_if<Call>(&effect.what);
            if (call == nullptr) continue;
            std::string words = std::string(control.calls[call->kind].name) + " of ";
            const auto* number = std::get_if<ExpressionId>(&call->program);
            const auto* literal =
                number == nullptr ? nullptr : std::get_if<Literal>(&program.expressions[*number].node);
            words += literal == nullptr ? "?" : std::to_string(static_cast<int>(literal->value));
            for (const Argument& argument :
                 std::span(program.arguments).subspan(call->arguments.first, call->arguments.count))
                words += " " + std::string(argument.address);
            if (call->repeat) words += " repeated";
            calls.push_back(words);
        }
    return calls;
}

/// On which any T word calls O9000.
ControlModel with_tool_call(const char* name) {
    ControlModel own = *find_control(name);
    own.own_codes = {{'T', 0, 9000}};
    own.lathes.clear();
    return own;
}

TEST(OwnCodes, AreTWordsWhoseNumbersTheirProgramFinds) {
    const ControlModel control = with_tool_call("fanuc-16i");
    EXPECT_THAT(calls_in("O1\nT5\nN7 T6 M6\nT#1\nM30\n", control),
                ElementsAre("M98 subprogram call of 9000", "M98 subprogram call of 9000",
                            "M98 subprogram call of 9000"));
    const ProgramFile file = read("O1\nT5\nM30\n", control, Extent::whole);
    const auto& effects = file.programs.front().effects;
    ASSERT_GE(effects.size(), 2U);
    const auto* stored = std::get_if<Assign>(&effects[0].what);
    ASSERT_NE(stored, nullptr);
    EXPECT_EQ(std::get<Variable>(stored->target).number, 149);
    EXPECT_THAT(calls_in("O9000\nT#149\nM99\n", control), IsEmpty()) << "in the program itself T is T";
    EXPECT_THAT(calls_in("O1\nT5\nM30\n", *find_control("fanuc-16i")), IsEmpty());
}

TEST(OwnCodes, OfALatheCallInPlaceOfTheTool) {
    const ControlModel control = with_tool_call("fanuc-16i-lathe");
    EXPECT_THAT(calls_in("O1\nT0101\nM30\n", control), ElementsAre("M98 subprogram call of 9000"));
    EXPECT_THAT(calls_in("O1\nG65 P9010 T5\nM30\n", control), ElementsAre("G65 macro call of 9010 T"));
}

TEST(OwnCodes, CallMacrosWithTheWordsOfTheirBlock) {
    EXPECT_THAT(calls_in("O1\nN5 G90 G81 X1. A5. B#100 L2\nM30\n", machine()),
                ElementsAre("G65 macro call of 9010 X A B repeated"));
    EXPECT_THAT(calls_in("O1\nM90 X1. S500\nM30\n", machine()), ElementsAre("G65 macro call of 9020 X S"));
}

TEST(OwnCodes, CallSubprogramsBesideTheWordsOfTheirBlock) {
    EXPECT_THAT(calls_in("O1\nG1 X1. M50\nM30\n", machine()), ElementsAre("M98 subprogram call of 9001"));
}

TEST(OwnCodes, AreOrdinaryCodesInTheProgramsThatTheyCall) {
    EXPECT_THAT(calls_in("O9010\nG81 Z-5. R1. F50\nM90\nM99\n", machine()), IsEmpty());
    EXPECT_THAT(calls_in("O9005\nG81 Z-5. R1. F50\nM99\n", machine()),
                ElementsAre("G65 macro call of 9010 Z R F"));
}

TEST(OwnCodes, AreOrdinaryOnOtherMachines) {
    EXPECT_THAT(calls_in("O1\nG81 Z-5. R1. F50\nM50\nM90\nM30\n", *find_control("fanuc-16i")), IsEmpty());
}

TEST(OwnCodes, SetNothingThatTheyWouldSetElse) {
    const ProgramFile file = read("O1\nG81 Z-5. R1. F50\nM30\n", machine(), Extent::whole);
    for (const Effect& effect : file.programs.front().effects)
        EXPECT_FALSE(std::holds_alternative<SetModal>(effect.what) ||
                     std::holds_alternative<Motion>(effect.what));
}

TEST(OwnCodes, AreSeenWhereOnlyNamesAndCallsAreRead) {
    const auto calls = [](const ControlModel& control) {
        return outline_of(read("O1\nG81 X1.\nG0 X#1\nM30\n", control, Extent::names_and_calls))
            .programs[0]
            .calls;
    };
    ASSERT_EQ(calls(machine()).size(), 1U);
    EXPECT_EQ(std::get<std::int64_t>(calls(machine()).front().program), 9010);
    EXPECT_THAT(calls(*find_control("fanuc-16i")), IsEmpty());
}

} // namespace
} // namespace maclint
