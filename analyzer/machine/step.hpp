//! What one block does to the machine.
#pragma once

#include "analyzer/machine/state.hpp"
#include "analyzer/machine/stored_variables.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace maclint::machine {

/// How a block moves.
enum class Move : std::uint8_t {
    none,
    rapid,
    feed,      ///< on a straight line, a circle or a thread
    cycle,     ///< a canned cycle at a position, or a turning cycle that returns to where it began
    elsewhere, ///< to a reference position, or in the machine's own coordinates
    unknown,
};

/// A number of a word, where it stands in the text.
struct Number {
    double value;
    bool decimal_point;
    Span span;

    /// Whether it says how long something is: a number without a point may count thousandths.
    [[nodiscard]] bool is_length() const { return decimal_point || value == 0; }
};

/// The words of a block by their letters, and its G codes.
class Words {
  public:
    Words(std::span<const Word> words, const MachineWords& machine);

    [[nodiscard]] bool has(char letter) const { return words_[index(letter)] != nullptr; }
    /// The first word of the letter, where it is a number; nothing where it is missing or calculated, or
    /// counts from elsewhere than such words do.
    [[nodiscard]] std::optional<Number> number(char letter) const;
    /// A number that counts from the program's zero, and says so.
    [[nodiscard]] std::optional<double> absolute(char letter) const;
    [[nodiscard]] const Word* word(char letter) const { return words_[index(letter)]; }
    [[nodiscard]] std::span<const double> g_codes() const { return g_codes_.all(); }
    [[nodiscard]] std::span<const double> m_codes() const { return m_codes_.all(); }
    [[nodiscard]] bool has_g(double code) const;
    [[nodiscard]] bool has_m(double code) const;
    [[nodiscard]] bool has_one_of(std::span<const double> wanted) const;
    /// From the first word to the last; empty where there are none.
    [[nodiscard]] Span span() const { return span_; }
    /// Whether a G word, an M word is calculated.
    [[nodiscard]] bool has_computed_code() const { return has_computed_code_; }
    [[nodiscard]] bool has_computed_function() const { return has_computed_function_; }
    /// Whether a word other than those of axes says where the move ends.
    [[nodiscard]] bool has_other_target() const { return has_other_target_; }

    /// Whether a word of several letters gives the highest speed of the spindle.
    [[nodiscard]] bool has_clamp() const { return has_clamp_; }
    /// Whether they say no more than how often (P) something is done.
    [[nodiscard]] bool only_count() const { return only_count_; }

  private:
    [[nodiscard]] static std::size_t index(char letter) { return static_cast<std::size_t>(letter - 'A'); }

    /// Of one letter; a block with more than these is one that no control takes.
    struct Codes {
        std::array<double, 16> codes;
        std::size_t count = 0;

        void add(double code) {
            if (count < codes.size()) codes[count++] = code;
        }
        [[nodiscard]] std::span<const double> all() const { return {codes.data(), count}; }
    };

    std::array<const Word*, 26> words_ = {};
    Codes g_codes_, m_codes_;
    Span span_ = {};
    bool has_computed_code_ = false, has_computed_function_ = false;
    bool has_other_target_ = false;
    bool has_clamp_ = false;
    bool only_count_ = true;
    bool lengths_without_point_;
};

/// One block between two states.
struct Step {
    const BlockView& block;
    const Words& words;
    const State& before;
    const State& after; ///< calls of the block left out
    Move move;
    std::array<bool, 3> axes; ///< of which a word stands in the block
    bool changes_tool;
    bool to_reference; ///< it runs to a reference position of the machine
    bool calls;        ///< it calls a program
};

/// How many mm an inch is, where positions are in inches.
inline constexpr double millimetres_of_inch = 25.4;

/// The code under which the group does nothing; nothing where the control has no such group, or code.
[[nodiscard]] std::optional<double> code_off(const ControlModel& control, ModalRole role);
/// Whether a code other than that is in force, by a block of the program.
[[nodiscard]] bool is_surely_on(const State& state, const ControlModel& control, ModalRole role);
/// Whether it may be: what the caller left is taken for off.
[[nodiscard]] bool may_be_on(const State& state, const ControlModel& control, ModalRole role);
/// Whether positions may count from elsewhere than the work offset says, or not along X and Y.
[[nodiscard]] bool counts_from_elsewhere(const State& state, const ControlModel& control);
/// Whether the block moves by feed, with the code of a circle in force.
[[nodiscard]] bool moves_on_circle(const Step& step, const ControlModel& control);
/// On a circle, or in a canned cycle.
[[nodiscard]] bool moves_on_shape(const Step& step, const ControlModel& control);
/// Whether the block moves by the F in force: those of a profile have their own, and that of a thread is its
/// lead.
[[nodiscard]] bool takes_feed(const Step& step, const MachineWords& machine);

/// Whether the spindle, or the coolant, that the program has switched on is on when the block begins and is
/// not switched off in it.
[[nodiscard]] bool spindle_runs_into(const Step& step, const ControlModel& control);
[[nodiscard]] bool coolant_runs_into(const Step& step, const ControlModel& control);

/// Whether a word of the block sets the group of that role.
[[nodiscard]] bool sets(const ControlModel& control, const BlockView& block, ModalRole role);

/// Runs blocks over a state.
class Stepper {
  public:
    Stepper(const Program& program, const MachineWords& machine);

    /// What the block does, calls left out; `visit(Step)` sees it.
    template<class Visit>
    void run(State& state, const BlockView& block, std::span<const Word> words, const Visit& visit) {
        const Words by_letter(words, *machine_);
        before_ = state;
        begin(block);
        apply(state, block, by_letter);
        visit(Step{block, by_letter, before_, state, move_, axes_, changes_tool_, to_reference_, calls_});
    }

  private:
    void begin(const BlockView& block);
    void apply(State& state, const BlockView& block, const Words& words);
    void apply_effects(State& state, const BlockView& block, const Words& words);
    void apply_functions(State& state, const Words& words, Offset here) const;
    void apply_settings(State& state, const BlockView& block) const;
    void apply_computed_code(State& state, ExpressionId code, const Words& words);
    void watch_demands(State& state, const Words& words) const;
    void change_tool(State& state, const BlockView& block, const Words& words) const;
    void watch_tapping(State& state, const BlockView& block, const Words& words) const;
    void choose_offsets(State& state, const BlockView& block, const Words& words) const;
    [[nodiscard]] Known chosen(const Words& words, char letter, Offset here) const;
    void move(State& state, const Words& words, Offset here);
    void run_blocks_elsewhere(State& state);
    void run_profile(State& state, const BlockView& block, const Words& words) const;
    void move_in_cycle(State& state, const Words& words) const;
    [[nodiscard]] bool stays_there(const State& state, const Words& words) const;
    [[nodiscard]] Move kind_of_move(const State& state, const Words& words) const;
    [[nodiscard]] std::optional<double> target(const State& state, const Words& words,
                                               std::size_t axis) const;

    const Program* program_;
    const ControlModel* control_;
    const MachineWords* machine_;
    const ShopDemands* demands_;                    ///< nullptr: no blocks are demanded
    std::shared_ptr<const StoredVariables> stored_; ///< copies share it: one is made for every node
    std::optional<GroupId> spindle_, cycle_;
    std::optional<double> spindle_off_, cycle_off_;
    bool has_distance_, has_level_; ///< groups that not every control has
    State before_;
    Move move_ = Move::none;
    std::array<bool, 3> axes_ = {};
    bool changes_tool_ = false;
    bool calls_ = false, passes_words_ = false;
    bool moves_ = false;
    bool without_feed_ = false;
    bool to_reference_ = false;
    bool has_applied_code_ = false; ///< one that is calculated
};

} // namespace maclint::machine
