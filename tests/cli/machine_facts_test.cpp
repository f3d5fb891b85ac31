//! What a shop tells of one machine, in the configuration and on the command line.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/own_codes.hpp"
#include "cli/config/configuration.hpp"
#include "cli/config/machine_facts.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/in_repository.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// "G81>9010", "G310", "-G51".
std::vector<std::string> codes_with(const MachineFacts& facts) {
    ControlModel control = *find_control("fanuc-16i");
    facts.apply_to(control);
    std::vector<std::string> codes;
    for (const OwnCode& code : control.own_codes)
        codes.push_back(code.program == not_fitted ? "-" + spelled(code)
                        : calls_program(code)      ? spelled(code) + ">" + std::to_string(code.program)
                                                   : spelled(code));
    return codes;
}

std::string message_of(const std::optional<WrongWord>& wrong) { return wrong ? wrong->message : "accepted"; }

TEST(MachineFacts, AreCodesCallsAndWhatIsNotFitted) {
    MachineFacts facts;
    EXPECT_TRUE(facts.empty());
    EXPECT_FALSE(facts.add_codes("m50-M52"));
    EXPECT_FALSE(facts.add_codes("G310"));
    EXPECT_FALSE(facts.add_missing("G54.1"));
    EXPECT_FALSE(facts.add_call("G310", "O9015")); // what it does says more than that it is there
    EXPECT_FALSE(facts.empty());
    EXPECT_THAT(codes_with(facts), ElementsAre("-G54.1", "G310>9015", "M50", "M51", "M52"));
    ControlModel control = *find_control("fanuc-16i");
    facts.apply_to(control);
    EXPECT_TRUE(are_listed(control, 'G') && are_listed(control, 'M'));
    EXPECT_NE(own_code(control, 'M', 51), nullptr);
    EXPECT_EQ(own_code(control, 'G', 51), nullptr);
}

TEST(MachineFacts, ListNoLetterByCallsAlone) {
    MachineFacts facts;
    EXPECT_FALSE(facts.add_call("G81", "9010"));
    ControlModel control = *find_control("fanuc-16i");
    facts.apply_to(control);
    EXPECT_FALSE(are_listed(control, 'G'));
}

TEST(MachineFacts, TakeTheParametersOfAFanuc) {
    MachineFacts facts;
    EXPECT_FALSE(facts.add_parameter("6050", 81));
    EXPECT_FALSE(facts.add_parameter("6059", 200));
    EXPECT_FALSE(facts.add_parameter("6071", 50));
    EXPECT_FALSE(facts.add_parameter("6089", 90));
    EXPECT_FALSE(facts.add_parameter("6051", 0));    // calls nothing
    EXPECT_FALSE(facts.add_parameter("6052", -120)); // after each move: not followed
    EXPECT_THAT(codes_with(facts), ElementsAre("G81>9010", "G120", "G200>9019", "M50>9001", "M90>9029"));
    EXPECT_THAT(message_of(facts.add_parameter("6060", 81)), HasSubstr("Known are 6050 to 6059"));
    EXPECT_THAT(message_of(facts.add_parameter("6050", 81.5)), HasSubstr("whole number"));
    EXPECT_THAT(message_of(facts.add_parameter("6071", -5)), HasSubstr("M code"));
}

TEST(MachineFacts, TakeTheBitThatLetsToolsCallAProgram) {
    MachineFacts facts;
    EXPECT_FALSE(facts.add_parameter("6001#5", 0));
    EXPECT_TRUE(facts.empty());
    EXPECT_FALSE(facts.add_parameter("6001#5", 1));
    EXPECT_THAT(codes_with(facts), ElementsAre("T>9000"));
    EXPECT_THAT(message_of(facts.add_parameter("6001#5", 32)), HasSubstr("0 or 1"));
}

TEST(MachineFacts, NameAxesOptionsAndHowLengthsCount) {
    MachineFacts facts;
    const ControlModel& model = *find_control("fanuc-16i");
    EXPECT_FALSE(facts.set_axes("xyzA"));
    facts.set_calculator_input(true);
    EXPECT_FALSE(facts.add_option("scaling", model));
    EXPECT_THAT(message_of(facts.set_axes("XYQ")), HasSubstr("does not name axes"));
    EXPECT_THAT(message_of(facts.set_axes("XX")), HasSubstr("letter of each once"));
    EXPECT_THAT(message_of(facts.set_axes("")), HasSubstr("has axes"));
    EXPECT_THAT(message_of(facts.add_option("scalin", model)), HasSubstr("Did you mean 'scaling'?"));
    EXPECT_THAT(message_of(facts.add_option("scaling", *find_control("haas"))),
                HasSubstr("is no option of haas"));
    ControlModel control = model;
    facts.apply_to(control);
    EXPECT_EQ(control.axes, "XYZA");
    EXPECT_TRUE(control.calculator_input);
    EXPECT_EQ(own_code(control, 'G', 51), nullptr);
    ASSERT_NE(own_code(control, 'G', 68), nullptr);
    EXPECT_EQ(own_code(control, 'G', 68)->program, not_fitted);
    EXPECT_FALSE(model.calculator_input);
    EXPECT_TRUE(find_control("nct")->calculator_input);
}

TEST(MachineFacts, SayMoreOfACodeThanItsOptionDoes) {
    MachineFacts facts;
    EXPECT_FALSE(facts.add_codes("G51"));
    facts.list_options();
    ControlModel control = *find_control("fanuc-16i");
    facts.apply_to(control);
    EXPECT_EQ(own_code(control, 'G', 51)->program, 0);
    EXPECT_EQ(own_code(control, 'G', 50)->program, not_fitted);
}

TEST(MachineFacts, AreAssignedOnTheCommandLine) {
    MachineFacts facts;
    for (const std::string_view word : {"G81=O9010", "6080=90", "6001#5=1"})
        EXPECT_FALSE(facts.add_assignment(word)) << word;
    EXPECT_THAT(codes_with(facts), ElementsAre("G81>9010", "M90>9020", "T>9000"));
    EXPECT_THAT(message_of(facts.add_assignment("G81")), HasSubstr("has no '='"));
    EXPECT_THAT(message_of(facts.add_assignment("G81=MACRO")), HasSubstr("is no program"));
    EXPECT_THAT(message_of(facts.add_assignment("6050=G81")), HasSubstr("is no number"));
}

TEST(MachineFacts, RefuseWordsThatAreNoCodes) {
    MachineFacts facts;
    for (const std::string_view word :
         {"", "G", "81", "X5", "G81-", "M59-M50", "G1-M5", "M5.5", "G54.15", "G-5"})
        EXPECT_THAT(message_of(facts.add_codes(word)), HasSubstr("is no G or M code")) << word;
    EXPECT_TRUE(facts.empty());
}

std::variant<std::shared_ptr<const Configuration>, Notice> loaded(std::string_view control) {
    const TemporaryFolder folder;
    const std::string text = R"({"controls": {"c": {"model": "fanuc-16i", )" + std::string(control) + "}}}";
    return load_configuration(folder.write(".maclint.json", text), Reach::of_folder(folder.path()));
}

std::string refusal(std::string_view control) {
    const auto result = loaded(control);
    const auto* notice = std::get_if<Notice>(&result);
    return notice == nullptr ? "accepted" : notice->message;
}

TEST(MachineFacts, StandInTheConfigurationOfAControl) {
    const auto result = loaded(R"("parameters": {"6050": 81}, "calls": {"M70": "O9005"}, "codes": ["G310"],
                                  "lacks": ["G51"])");
    const ControlModel& control = *std::get<0>(result)->control("c");
    ASSERT_EQ(control.own_codes.size(), 4U);
    EXPECT_EQ(own_code(control, 'G', 81)->program, 9010);
    EXPECT_EQ(own_code(control, 'M', 70)->program, 9005);
    EXPECT_EQ(own_code(control, 'G', 51)->program, not_fitted);
    EXPECT_EQ(control.letters_listed, "G");
    EXPECT_THAT(find_control("fanuc-16i")->own_codes, IsEmpty());
}

TEST(MachineFacts, ThatAreWrongAreToldToTheirAuthor) {
    EXPECT_THAT(refusal(R"("parameters": {"6049": 81})"), HasSubstr("Known are 6050"));
    EXPECT_THAT(refusal(R"("parameters": {"6050": "G81"})"), HasSubstr("must be a number"));
    EXPECT_THAT(refusal(R"("parameters": [6050])"), HasSubstr("must be an object"));
    EXPECT_THAT(refusal(R"("codes": ["H5"])"), HasSubstr("is no G or M code"));
    EXPECT_THAT(refusal(R"("codes": "G310")"), HasSubstr("must be a list"));
    EXPECT_THAT(refusal(R"("lacks": [51])"), HasSubstr("must be a text"));
    EXPECT_THAT(refusal(R"("calls": {"G81": 9010})"), HasSubstr("must be a text"));
    EXPECT_THAT(refusal(R"("calls": {"T5": "O9010"})"), HasSubstr("is no G or M code"));
    EXPECT_THAT(refusal(R"("axes": ["X"])"), HasSubstr("must be a text"));
    EXPECT_THAT(refusal(R"("options": ["scalin"])"), HasSubstr("Did you mean 'scaling'?"));
    EXPECT_THAT(refusal(R"("calculator-input": 1)"), HasSubstr("'calculator-input'"));
    EXPECT_EQ(refusal(R"("axes": "XYZ", "options": [], "calls": {"T": "O9000"})"), "accepted");
}

class MachineFactsOfARun : public test::InRepository {};

constexpr std::string_view main_program = "%\nO1000 (PLATE)\nG0 X1.\nG81 A5.\nM30\n%\n";
/// Reads an argument that the block with G81 lacks.
constexpr std::string_view macro = "%\nO9010 (HOLES)\nG0 X#2\nG1 Y#1 F100\nM99\n%\n";

TEST_F(MachineFactsOfARun, ShowInTheConfigurationOfAFile) {
    folder.write("O1000.nc", main_program);
    const std::string shown = run({"--show-config", "--calls", "G81=O9010,6071=50", "--codes", "G310",
                                   "--lacks", "G51", "O1000.nc"})
                                  .out;
    EXPECT_THAT(shown, HasSubstr("own codes      G81 calls O9010, G310 and M50 calls O9001; lacks G51"));
    EXPECT_THAT(run({"--show-config", "O1000.nc"}).out, testing::Not(HasSubstr("own codes")));
}

TEST_F(MachineFactsOfARun, MakeCodesCallTheirPrograms) {
    folder.write("O1000.nc", main_program);
    folder.write("O9010.nc", macro);
    const auto found = [&](const std::vector<std::string>& calls) {
        std::vector<std::string> words = {"check", "--format", "concise", "--control", "fanuc-16i", "."};
        words.insert(words.end(), calls.begin(), calls.end());
        return run(words).out;
    };
    EXPECT_THAT(found({}), HasSubstr("O1000.nc:4:1: warning[MAC523/G81.R]")); // it is the drilling cycle
    EXPECT_THAT(found({"--calls", "6050=81"}), testing::Not(HasSubstr("MAC523/G81.R")));
    EXPECT_THAT(found({"--calls", "G81=O9011"}), testing::Not(HasSubstr("MAC523/G81.R")));
}

TEST_F(MachineFactsOfARun, ThatAreNoneAreRefused) {
    EXPECT_THAT(run({"--codes", "H5", "."}).err, HasSubstr("--codes: 'H5' is no G or M code."));
    EXPECT_EQ(run({"--calls", "G81", "."}).status, 2);
    EXPECT_THAT(run({"--axes", "XQ", "."}).err, HasSubstr("--axes: 'XQ' does not name axes."));
    EXPECT_THAT(run({"--options", "nothing", "."}).err,
                HasSubstr("--options: 'nothing' is no option of fanuc"));
}

} // namespace
} // namespace maclint::cli
