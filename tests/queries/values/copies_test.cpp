//! What a value is a copy of, however many assignments lie between.
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "tests/support/analysed.hpp"

#include <memory>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The text from which the value of the last word with a group was copied; empty when it is no copy.
std::string source_of_last_word(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text + "M99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const dataflow::ModalWrite& word = analysis.facts().all<dataflow::ModalWrite>().back();
    const auto source = copy_source(analysis, word.expression, word.value);
    return source ? test::text_of(analysis, analysis.program().expressions[source->expression].span)
                  : std::string();
}

TEST(CopySource, IsWhatWasReadFirst) {
    EXPECT_EQ(source_of_last_word("#33=#4003\nG91\nG#33\n"), "#4003");
    EXPECT_EQ(source_of_last_word("#33=#4003\n#32=#33\n#31=#32\nG91\nG#31\n"), "#4003");
    EXPECT_EQ(source_of_last_word("#33=#4019\nF#33\n"), "#4019");
    EXPECT_EQ(source_of_last_word("F#4109\n"), "#4109");
}

TEST(CopySource, IsNoneOfWhatIsComputedOrOneOfSeveral) {
    EXPECT_EQ(source_of_last_word("#33=#4109/2\nF#33\n"), "");
    EXPECT_EQ(source_of_last_word("F#9\n"), "");
    EXPECT_EQ(source_of_last_word("#33=#4109\nIF[#1EQ1]GOTO5\n#33=#4119\nN5F#33\n"), "");
}

TEST(CopySource, TellsAModalGroupFromAMachineValue) {
    const auto workspace = test::analyse_fanuc("O9001\n#1=#4003\nG#1\n#2=#5003\nF#2\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto words = analysis.facts().all<dataflow::ModalWrite>();
    ASSERT_EQ(words.size(), 2U);
    const auto mode = copy_source(analysis, words[0].expression, words[0].value);
    EXPECT_EQ(mode.value().group, analysis.control().group_with(ModalRole::distance));
    EXPECT_EQ(mode.value().range, nullptr);
    const auto position = copy_source(analysis, words[1].expression, words[1].value);
    EXPECT_EQ(position.value().group, std::nullopt);
    EXPECT_NE(position.value().range, nullptr);
}

TEST(Stores, AreNoneWhereSeveralMayHaveMadeTheValue) {
    const auto store_line = [](const std::string& text) -> std::uint32_t {
        const auto workspace = test::analyse_fanuc("O9001\n" + text + "X#5\nM99\n");
        const ProgramAnalysis& analysis = workspace->programs().front();
        const dataflow::Store* store = store_of(analysis, test::last_read(analysis));
        return store == nullptr ? 0 : test::line_of_effect(analysis, store->effect);
    };
    EXPECT_EQ(store_line("#5=#501\n#6=1\n"), 2U);
    EXPECT_EQ(store_line("IF[#501EQ1]GOTO7\n#5=#502\nGOTO8\nN7#5=#503\nN8"), 0U);
    EXPECT_EQ(store_line("#6=1\n"), 0U);
}

TEST(SavedGroup, IsKnownByThePlainReadThatIsStored) {
    const auto workspace = test::analyse_fanuc("O9001\n#1=#4003\n#2=#4001+0\n#3=7\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto stores = analysis.facts().all<dataflow::Store>();
    ASSERT_EQ(stores.size(), 3U);
    const GroupId distance = analysis.control().group_with(ModalRole::distance).value();
    ASSERT_NE(modal_read_of(analysis, stores[0]), nullptr);
    EXPECT_EQ(modal_read_of(analysis, stores[0])->group, distance);
    EXPECT_EQ(modal_read_of(analysis, stores[1]), nullptr);
    EXPECT_EQ(modal_read_of(analysis, stores[2]), nullptr);
    EXPECT_TRUE(saves_group(analysis, distance));
    EXPECT_FALSE(saves_group(analysis, analysis.control().group_with(ModalRole::plane).value()));
}

TEST(SameValues, AreResultsOfOneComputation) {
    const auto workspace = test::analyse_fanuc("O9001\n#1=#501\n#2=#1\n#3=#502\nX#1Y#2Z#3\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto reads = analysis.facts().all<dataflow::Read>();
    const auto value = [&](std::size_t from_the_end) { return reads[reads.size() - from_the_end].value; };
    EXPECT_TRUE(is_same_value(value(3), value(2)));
    EXPECT_FALSE(is_same_value(value(3), value(1)));
    EXPECT_TRUE(is_copied_into(analysis, {0, 2}, value(3)));
    EXPECT_FALSE(is_copied_into(analysis, {0, 3}, value(3)));
}

} // namespace
} // namespace maclint::queries
