//! MAC123: codes that neither the control nor its machine has.
#include "analyzer/dialect/dialect.hpp"
#include "rules/words/known_codes.hpp"
#include "tests/support/linted.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Machine123 {
    std::string control;
    std::vector<std::string> codes = {}, lacks = {}, calls = {};
};

/// "warning 2: G6".
std::vector<std::string> told(const std::vector<LintedText>& texts, const Machine123& machine) {
    cli::Overrides overrides;
    overrides.select = {"MAC123"};
    overrides.control = machine.control;
    for (const std::string& word : machine.codes) EXPECT_FALSE(overrides.machine.add_codes(word));
    for (const std::string& word : machine.lacks) EXPECT_FALSE(overrides.machine.add_missing(word));
    for (const std::string& word : machine.calls) EXPECT_FALSE(overrides.machine.add_assignment(word));
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : lint_texts(texts, std::move(overrides)).findings)
        all.push_back((finding.severity == Severity::warning ? "warning " : "note ") +
                      std::to_string(finding.source->position(finding.span.begin).line) + ": " +
                      std::string(finding.message_id));
    return all;
}
std::vector<std::string> told(const std::string& blocks, const Machine123& machine) {
    return told({{"shop/O1.nc", "O1\nG0 X1.\n" + blocks + "M30\n"}}, machine);
}

TEST(UnknownCode, OfANamedControlIsAWarning) {
    EXPECT_THAT(told("G6 X5.\nG1 Y#1 F100. G12\n", {"fanuc-16i"}),
                ElementsAre("warning 3: unknown", "warning 4: unknown"));
    EXPECT_THAT(told("G12 I5. D1 F100.\n", {"haas"}), IsEmpty());
}

TEST(UnknownCode, OfAnAssumedControlIsANoteWhereNoControlHasIt) {
    EXPECT_THAT(told("G6 X5.\nG12 I5. D1 F100.\n", {}), ElementsAre("note 3: of-no-control"));
}

TEST(UnknownCode, MayBeTheMachinesOwnFromAHundredOn) {
    EXPECT_THAT(told("G441 X5.\nM55\n", {"fanuc-16i"}), IsEmpty());
    EXPECT_THAT(told("G441 X5.\nG310 X5.\nM55\n", {"fanuc-16i", {"G310"}}),
                ElementsAre("warning 3: not-listed"));
    EXPECT_THAT(told("G441 X5.\nM8\nM55\nM50\nM1055\n", {"fanuc-16i", {"M50-M53"}}),
                ElementsAre("warning 5: not-listed", "warning 7: not-listed"));
}

TEST(UnknownCode, IsNoArgument) {
    EXPECT_THAT(told("G65 P9100 M55\nG66 P9100 M55\n", {"fanuc-16i", {"M50"}}), IsEmpty());
}

TEST(UnknownCode, ThatTheMachineLacksIsTold) {
    EXPECT_THAT(told("G51 X0. Y0. P2.\n", {"fanuc-16i", {}, {"G51"}}), ElementsAre("warning 3: not-fitted"));
    EXPECT_THAT(told("G51 X0. Y0. P2.\n", {"fanuc-16i"}), IsEmpty());
}

TEST(UnknownCode, MayCallAMacroOfItsFolder) {
    const LintedText macro{"shop/O9010.nc", "O9010\nG0 X#24\nM99\n"};
    const LintedText main{"shop/O1.nc", "O1\nG6 X5.\nM30\n"};
    EXPECT_THAT(told({main, macro}, {"fanuc-16i"}), IsEmpty());
    EXPECT_THAT(told({main, {"other/O9010.nc", macro.text}}, {"fanuc-16i"}),
                ElementsAre("warning 2: unknown"));
    EXPECT_THAT(told({main, {"shop/O9030.nc", "O9030\nM99\n"}}, {"fanuc-16i"}),
                ElementsAre("warning 2: unknown"));
    EXPECT_THAT(told({main}, {"fanuc-16i", {}, {}, {"G6=O9010"}}), IsEmpty());
}

TEST(UnknownCode, IsFoundAmongPlainBlocks) {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += "X50. Y-5.\nX60.\n";
    EXPECT_THAT(told(text + "G6 X2.\n" + text, {"fanuc-16i"}), ElementsAre("warning 6003: unknown"));
}

TEST(CodesToLookAt, AreFew) {
    const auto unknown = codes_to_look_at(*find_control("fanuc-16i"));
    EXPECT_FALSE(unknown->codes.empty());
    syntax::CodeSet usual;
    for (const std::uint64_t code : {0U, 1U, 2U, 3U, 17U, 40U, 43U, 54U, 80U, 81U, 90U, 91U})
        usual.add(syntax::CodeSet::kind_of(0, code));
    for (const std::uint64_t code : {3U, 5U, 6U, 8U, 9U, 30U}) usual.add(syntax::CodeSet::kind_of(1, code));
    EXPECT_FALSE(unknown->kinds.meets(usual)); // blocks of nothing else are not read for it
}

} // namespace
} // namespace maclint::test
