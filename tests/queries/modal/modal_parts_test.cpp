//! What one thing that a modal group can be is, and whose.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// A called program, and all that a group can be when it returns.
class LeftWith {
  public:
    LeftWith(const std::string& text, ModalRole role)
        : LeftWith(text, [role](const ControlModel& control) { return control.group_with(role).value(); }) {}
    LeftWith(const std::string& text, char letter)
        : LeftWith(text, [letter](const ControlModel& control) {
            const auto found = std::ranges::find(control.groups, letter, &ModalGroup::letter);
            return static_cast<GroupId>(found - control.groups.begin());
        }) {}

    const ProgramAnalysis& analysis() const { return workspace_->programs().front(); }
    GroupId group() const { return group_; }
    const dataflow::ModalPart& only() const {
        EXPECT_EQ(value_.parts.end() - value_.parts.begin(), 1);
        return value_.parts.front();
    }

  private:
    template<class Find>
    LeftWith(const std::string& text, const Find& find)
        : workspace_(test::analyse_fanuc("O9001\n" + text + "M99\n"))
        , group_(find(analysis().control()))
        , value_(analysis().data().modal(analysis().facts().all<dataflow::ExitState>().front(), group_)) {}

    std::unique_ptr<Workspace> workspace_;
    GroupId group_;
    dataflow::ModalValue value_;
};

using Code = std::optional<double>;

TEST(ModalParts, AreOwnCodesWhenALiteralWordSetThem) {
    const LeftWith plain("G91\n", ModalRole::distance);
    EXPECT_EQ(own_code(plain.analysis(), plain.only()), Code(91));
    const LeftWith word("#1=#2\nG91X#1\n", ModalRole::distance);
    EXPECT_EQ(own_code(word.analysis(), word.only()), Code(91));
    const LeftWith computed("#1=91\nG#1\n", ModalRole::distance);
    EXPECT_EQ(code_of(computed.analysis(), computed.only()), Code(91));
    EXPECT_EQ(own_code(computed.analysis(), computed.only()), Code());
}

TEST(ModalParts, AreSwitchedOnUnlessTheyAreCustomaryOrCancel) {
    const auto switched_on = [](const std::string& text, ModalRole role) {
        const LeftWith left(text, role);
        return is_switched_on(left.analysis(), left.analysis().control().groups[left.group()], left.only());
    };
    EXPECT_TRUE(switched_on("G41D1\n", ModalRole::cutter_compensation));
    EXPECT_FALSE(switched_on("G40\n", ModalRole::cutter_compensation));
    EXPECT_TRUE(switched_on("G91\n", ModalRole::distance));
    EXPECT_FALSE(switched_on("G90\n", ModalRole::distance));
}

TEST(ModalParts, MayBeTheCallersWhenNothingElseSetsThem) {
    const auto callers = [](const std::string& text) {
        const LeftWith left(text, ModalRole::distance);
        return may_be_callers(left.analysis(), left.group(), left.only());
    };
    EXPECT_TRUE(callers("G0\n"));
    EXPECT_TRUE(callers("#33=#4003\nG91\nG#33\n"));
    EXPECT_FALSE(callers("G91\n"));
    EXPECT_FALSE(callers("#33=#4002\nG#33\nG91\n"));
}

TEST(ModalParts, HaveASourceOfTheirNumber) {
    const auto source = [](const std::string& text) {
        const LeftWith left(text, 'F');
        return source_of(left.analysis(), left.only());
    };
    EXPECT_EQ(source("F200.\n"), NumberSource::constant);
    EXPECT_EQ(source("#33=200\nF#33\n"), NumberSource::constant);
    EXPECT_EQ(source("#33=#501/2\nF#33\n"), NumberSource::calculated);
    EXPECT_EQ(source("#33=#4109\nF#33\n"), NumberSource::other);
    EXPECT_EQ(source("X1.\n"), NumberSource::other);
}

TEST(ModalParts, OfAnArgumentAreWhatTheVariableHeldAtTheStart) {
    const LeftWith left("F100.\nIF[#9EQ#0]GOTO9\nF#9\nM99\nN9#3000=1(F)\n", 'F');
    EXPECT_EQ(source_of(left.analysis(), left.only()), NumberSource::at_start);
}

TEST(EffectsInForce, AreThoseThatNoOtherReplaces) {
    const auto workspace = test::analyse_fanuc("O9001\n#1=#2\nG91X#1\nG90X#1\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::string> texts;
    for (const EffectId effect : effects_in_force_at_return(analysis))
        texts.push_back(test::text_of(analysis, analysis.program().effects[effect].span));
    EXPECT_THAT(texts, testing::ElementsAre("G90"));
}

TEST(AnotherCode, IsOneThatIsInForceOnNoPath) {
    const auto sets_another = [](const std::string& blocks) {
        const auto workspace = test::analyse_text("dinplus", "MACHINING\nN1 INPUT(\"A\",#l1)\n" + blocks +
                                                                 " X#l1\nN9 M30\nEND\n");
        const ProgramAnalysis& analysis = workspace->programs().front();
        const auto points = analysis.facts().all<dataflow::BeforeWatchedWord>();
        return !points.empty() && sets_another_code(analysis, points.back(), ModalRole::plane);
    };
    EXPECT_TRUE(sets_another("N2 G18 X#l1\nN3 G17"));
    EXPECT_FALSE(sets_another("N2 G17 X#l1\nN3 G17"));
    EXPECT_FALSE(sets_another("N2 G18 X#l1\nN3 IF #l1>2\nN4 THEN\nN5 G17 X#l1\nN6 ENDIF\nN7 G17"));
    EXPECT_FALSE(sets_another("N2 G18 X#l1\nN3 G42"));
}

} // namespace
} // namespace maclint::queries
