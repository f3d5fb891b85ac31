//! Which modal codes are in force at a block: a plain one in the middle of a run, or one with effects.
#pragma once

#include "analyzer/dataflow/domain/small_vector.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace maclint::queries {

/// One thing that a modal group can be, and where it comes from.
struct Mode {
    std::optional<double> code; ///< nothing: it is computed, or the caller's
    enum class SetBy : std::uint8_t {
        nobody, ///< it was so when the program began: the control's reset, or the caller
        word,   ///< of this program
        call,   ///< a program that this one calls has left it so
    } set_by;
    flow::NodeId node;         ///< where it was set; the program's first where nobody did
    dataflow::OriginId origin; ///< as data flow has it; 0: nobody, or a word in the node of the block
    Span block = {};           ///< whose word it is, where `origin` does not say it
    friend bool operator==(const Mode&, const Mode&) = default;
};

/// The bytes that set it: see span_of_origin.
[[nodiscard]] Span span_of(const ProgramAnalysis& analysis, const Mode& mode);

/// All that a modal group can be at one place: each on some path, or in some of the channels that run the
/// block. Nothing where no path comes.
struct Modes {
    dataflow::SmallVector<Mode, 2> possible;
    bool unknown = false; ///< or anything else

    /// The code, where it is known and the same on all paths.
    [[nodiscard]] std::optional<double> sure_code() const;
    /// Whether on all paths it is one of these.
    [[nodiscard]] bool is_surely_one_of(std::span<const double> codes) const;
    /// Whether it is known to be this on some path.
    [[nodiscard]] bool can_be(double code) const;
};

class ModesAt;

/// What is in force at one block; good as long as the view of the block is, and until the next is asked for.
class BlockModes {
  public:
    /// Whether any path leads to the block.
    [[nodiscard]] bool reached() const;
    /// When the block begins.
    [[nodiscard]] Modes before(GroupId group) const;
    /// When its own words have set what they set, before it moves, calls or ends anything.
    [[nodiscard]] Modes with_words(GroupId group) const;

  private:
    friend class ModesAt;
    BlockModes(ModesAt& modes, const BlockView& block)
        : modes_(&modes)
        , block_(&block) {}
    ModesAt* modes_;
    const BlockView* block_;
};

/// Answers for the blocks of one program: `modes_at(block).before(group)`. Blocks that are asked about in
/// text order cost one pass over them together, and a run of plain blocks is read only where it sets the
/// group. Rules that ask declare dataflow::BeforeNode.
class ModesAt {
  public:
    explicit ModesAt(const ProgramAnalysis& analysis);
    [[nodiscard]] BlockModes operator()(const BlockView& block);

  private:
    friend class BlockModes;

    void enter(std::optional<flow::NodeId> node);
    [[nodiscard]] Modes before(const BlockView& block, GroupId group);
    [[nodiscard]] Modes with_words(const BlockView& block, GroupId group);
    [[nodiscard]] const Modes& before_node(GroupId group);
    [[nodiscard]] Mode mode_of(GroupId group, const dataflow::ModalPart& part) const;
    [[nodiscard]] bool is_set_in_node(GroupId group) const;
    [[nodiscard]] bool calls_may_change(GroupId group);
    [[nodiscard]] const EndedGroup* end_of(GroupId group, GroupId by) const;
    void read_up_to(const BlockView& block);
    void set(GroupId group, double code, Span block);
    [[nodiscard]] Modes set_here(double code, Span block) const;

    /// What the blocks of the node before the one asked about have set.
    struct Set {
        std::uint32_t visit = 0; ///< of the node in which that is so
        double code = 0;
        Span block = {};
    };
    struct AtNode {
        std::uint32_t visit = 0;
        Modes modes;
    };

    const ProgramAnalysis& analysis_;
    std::span<const EndedGroup> ended_groups_;
    std::optional<GroupId> modal_call_group_;
    std::optional<flow::NodeId> node_;
    const dataflow::BeforeNode* state_ = nullptr; ///< in front of the node
    std::uint32_t visit_ = 0;                     ///< of a node: what was kept of others does not count
    std::vector<AtNode> at_node_;                 ///< by group
    std::vector<Set> set_;                        ///< by group
    Offset read_to_ = 0;             ///< blocks of the node that begin before it have been passed
    bool moved_ = false;             ///< one of them moves
    std::vector<ModalSetting> last_; ///< of the block that begins at `read_to_`
    Span last_block_ = {};           ///< empty: nothing is known of it
    bool last_moves_ = false;
};

/// What the last word in a node for the group sets it to, or that of a group which ends it, calls left out;
/// nothing where none stands there.
[[nodiscard]] std::optional<BlockSetting> last_setting_in(const ProgramAnalysis& analysis, flow::NodeId node,
                                                          GroupId group);

/// Calls `visit(BlockView, BlockModes)` for all blocks of the program in text order.
template<class Visit>
void for_each_block_with_modes(const ProgramAnalysis& analysis, const Visit& visit) {
    ModesAt modes_at(analysis);
    for_each_block(analysis.program(), [&](const BlockView& block) { visit(block, modes_at(block)); });
}

} // namespace maclint::queries
