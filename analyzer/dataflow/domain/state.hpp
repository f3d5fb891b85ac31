//! What is known at one point of a program: every variable, every modal group.
#pragma once

#include "analyzer/dataflow/domain/persistent_map.hpp"
#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/program/channels.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace maclint::dataflow {

/// How a program is entered.
enum class Entry : std::uint8_t {
    main,           ///< nobody calls it: locals vacant, modal groups at their reset codes
    called_unknown, ///< callers unknown: arguments may be missing, modal groups are the caller's
};

/// A variable whose number is known; nothing: it is vacant.
struct KnownVariable {
    Variable variable;
    std::optional<double> number;
    friend bool operator==(const KnownVariable&, const KnownVariable&) = default;
};

/// What the callers tell of a program's local variables.
struct EntryKnowledge {
    Entry entry;
    std::vector<Variable> passed_somewhere; ///< arguments that some known caller passes, in no order
    /// All callers are known: whether each argument is passed by all, some or none of them. Absent: there may
    /// be other callers.
    std::optional<std::vector<std::pair<Variable, Vacancy>>> arguments;
    /// Some caller shares its locals with the program: what they hold at the start is unknown.
    bool locals_are_callers = false;
    /// Which of these some known caller may have set; absent: any.
    std::optional<std::vector<Variable>> set_by_callers = {};
    /// Numbers of shared names that several names have (SharedNames); sorted.
    std::span<const std::int32_t> ambiguous_names = {};
    /// Variables that a program further up may hand down; absent: it is unknown which.
    std::optional<std::vector<Variable>> handed_down = std::vector<Variable>{};
    /// What one call is known to begin with, where only that call is looked at.
    std::vector<KnownVariable> known = {};
};

[[nodiscard]] constexpr Key key_of(Variable variable) {
    return (Key{variable.space} + 1) << 32U | static_cast<std::uint32_t>(variable.number);
}
constexpr Key group_keys = Key{0x100} << 32U;
constexpr Key entry_code_keys = Key{0x200} << 32U;
/// A modal group as one channel has it. A program that names no channel runs in channel 0.
struct ChannelGroup {
    std::uint8_t channel;
    GroupId group;
};
constexpr unsigned bits_of_group = 8;
[[nodiscard]] constexpr Key key_of(ChannelGroup of) {
    return group_keys | Key{of.channel} << bits_of_group | of.group;
}
[[nodiscard]] constexpr ChannelGroup group_of(Key key) {
    return {static_cast<std::uint8_t>(key >> bits_of_group), static_cast<GroupId>(key)};
}
/// Under this key a state holds the code that the caller's group is known to have on this path.
[[nodiscard]] constexpr Key entry_code_key(ChannelGroup of) {
    return entry_code_keys | Key{of.channel} << bits_of_group | of.group;
}

[[nodiscard]] constexpr bool is_variable_key(Key key) { return key < group_keys; }
[[nodiscard]] constexpr bool is_group_key(Key key) { return key >= group_keys && key < entry_code_keys; }
[[nodiscard]] constexpr Variable variable_of(Key key) {
    return {static_cast<SpaceId>((key >> 32U) - 1),
            static_cast<std::int32_t>(static_cast<std::uint32_t>(key))};
}

struct State {
    Root root = 0;
    HavocId havoc = 0;
    bool reached = false;
};

/// The operations on states of one program's analysis.
class States {
  public:
    States(const Program& program, EntryKnowledge knowledge);

    [[nodiscard]] State at_entry() const;
    [[nodiscard]] bool is_vacant_at_entry(Variable variable) const;
    /// The program shares its callers' local variables, and no known caller sets this one.
    [[nodiscard]] bool is_set_by_no_caller(Variable variable) const;
    [[nodiscard]] Value read(const State& state, Variable variable);
    /// The number of that value in the table.
    [[nodiscard]] std::uint32_t id_of(const State& state, Variable variable);
    [[nodiscard]] const ModalValue& read(const State& state, ChannelGroup of) const;
    [[nodiscard]] ModalId id_of(const State& state, ChannelGroup of) const;
    /// All that the group can be in any of the channels.
    [[nodiscard]] ModalValue read(const State& state, Channels channels, GroupId group) const;
    [[nodiscard]] std::optional<double> entry_code(const State& state, ChannelGroup of) const;
    void write(State& state, Variable variable, const Value& value);
    void write(State& state, ChannelGroup of, ModalValue value);
    void write(State& state, ChannelGroup of, ModalId value);
    /// Every group of the channel at a time, or PersistentMap::absent for those that stay.
    void write_groups(State& state, std::uint8_t channel, std::span<const ModalId> values);
    [[nodiscard]] ModalId remember(ModalValue value);
    void know_entry_code(State& state, ChannelGroup of, double code);
    /// These channels do not come this way: until other paths join, their groups have no value at all.
    void leave_out(State& state, Channels channels);
    /// Everything in the space may have changed; `site` makes the new values differ from others.
    void havoc(State& state, SpaceId space, const Origin& site);

    [[nodiscard]] bool equal(const State& a, const State& b) const;
    /// Both paths meet at `node`.
    [[nodiscard]] State join(const State& a, const State& b, std::uint32_t node);
    /// As join, but bounds that grow jump to the next number of `thresholds` (sorted) or to infinity.
    [[nodiscard]] State widen(const State& old, const State& now, std::uint32_t node,
                              std::span<const double> thresholds);

    /// From now on only the modal groups of these states are asked for; the memory of all else is given back.
    void keep_groups_of(std::span<State* const> states);

    [[nodiscard]] ValueTable& table() { return table_; }
    [[nodiscard]] const ValueTable& table() const { return table_; }
    [[nodiscard]] PersistentMap& trees() { return maps_; }
    [[nodiscard]] Entry entry() const { return knowledge_.entry; }
    /// Variables of programs further up that are known to be handed down to this one.
    [[nodiscard]] std::span<const Variable> handed_down() const {
        return knowledge_.handed_down ? std::span<const Variable>(*knowledge_.handed_down)
                                      : std::span<const Variable>{};
    }
    [[nodiscard]] std::span<const std::int32_t> ambiguous_names() const { return knowledge_.ambiguous_names; }
    /// The value as a variable of that type holds it.
    [[nodiscard]] Value typed(const Value& value, Variable variable);

  private:
    using Widening = const std::function<void(const Value& old, Value& now)>;
    [[nodiscard]] State merge(const State& a, const State& b, std::uint32_t node, Widening& widening);
    [[nodiscard]] Value entry_value(Variable variable);
    [[nodiscard]] std::optional<double> initial_number(Variable variable) const;
    [[nodiscard]] Vacancy vacancy_at_entry(Variable variable) const;
    [[nodiscard]] bool may_be_handed_down(Variable variable) const;
    /// The value of a variable that a state does not hold.
    [[nodiscard]] Value absent(const State& state, Key key);
    [[nodiscard]] std::uint32_t entry_id(Key key);
    [[nodiscard]] ModalId absent_modal(Key key) const;
    [[nodiscard]] bool is_entry_of(OriginId vacancy_origin, Key key) const;
    [[nodiscard]] ModalId join_modals(ModalId a, ModalId b);
    [[nodiscard]] Value join_values(const Value& a, const Value& b, Key key, std::uint32_t node);

    const Program& program_;
    EntryKnowledge knowledge_;
    ValueTable table_;
    PersistentMap maps_;
    Root entry_values_ = 0; ///< those that were asked for
    std::vector<ModalId> entry_modals_;
    std::vector<Key> handed_down_; ///< variables that are known to be, sorted
};

/// With more possible codes than this a modal group counts as unknown.
constexpr std::size_t most_modal_parts = 12;

} // namespace maclint::dataflow
