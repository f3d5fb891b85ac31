//! Writes a program: its expressions, effects, words, blocks, sections and names. Nothing else does.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// What a block that could not be read names; see UnreadableBlock.
struct NamedInBlock {
    std::vector<Variable> variables;
    std::vector<Label> labels;
    bool may_open_or_close = false;
    bool may_call_or_return = false;
};

/// A program that is being read. One object writes block after block: its lists keep their memory.
class ProgramBuilder {
  public:
    /// `text` is the whole file's.
    ProgramBuilder(std::string name, std::string_view text, const ControlModel& control);

    /// What has been written so far.
    [[nodiscard]] const Program& program() const { return program_; }
    /// The finished program; nothing can be written after it.
    [[nodiscard]] Program take();

    // ---- what the program is
    void set_number(std::int64_t number) { program_.number = number; }
    void set_name_span(Span span) { program_.name_span = span; }
    /// A further name that a call may use; one that it has already is passed over.
    void add_name(std::string_view name);
    void set_folder(std::string folder) { program_.folder = std::move(folder); }
    void set_local() { program_.local = true; }
    void set_started(Program::Started started) { program_.started = started; }
    void set_plain_tables(decltype(Program::plain_tables) tables) { program_.plain_tables = tables; }

    // ---- sections
    /// Ends the section before, if there is one.
    void begin_section(std::string_view kind, Section::Executed executed, Span heading);
    [[nodiscard]] bool has_sections() const { return !program_.sections.empty(); }

    /// The program runs in these channels, too.
    void add_channels(Channels channels) {
        program_.channels = static_cast<Channels>(program_.channels | channels);
    }
    /// The blocks of a section that name no channel run in these.
    void set_channels(std::size_t section, Channels channels) {
        program_.sections[section].channels = channels;
        add_channels(channels);
    }

    // ---- names of blocks
    [[nodiscard]] BlockName block_name(std::string_view name) {
        return {program_.block_names.number_of(name)};
    }

    // ---- names of variables
    /// The number of a name, which gets one when it is new.
    [[nodiscard]] std::int32_t number_of_name(SpaceId space, std::string_view name);
    /// The next parameter.
    void add_formal(Formal formal) { program_.formals.push_back(std::move(formal)); }
    /// The program asks which of them were passed.
    void allow_missing_arguments() {
        for (Formal& formal : program_.formals) formal.has_default = formal.passing == Passing::by_value;
    }
    void add_external(ExternalDeclaration declared) { program_.externals.push_back(std::move(declared)); }
    void add_unknown_name(UnknownName name) { program_.unknown_names.push_back(std::move(name)); }
    void give_name(std::string capitals) { program_.given_names.push_back(std::move(capitals)); }
    void give_word(GivenWord word) { program_.given_words.push_back(std::move(word)); }
    void add_array(ArrayDefinition array) { program_.arrays.push_back(std::move(array)); }
    void add_foreign_element(std::string array, std::span<const ExpressionId> indices, Span span) {
        program_.foreign_elements.push_back({std::move(array), add_operands(indices), span});
    }
    void add_array_index(const ArrayIndex& index) { program_.array_indices.push_back(index); }
    void set_parameters_unknown() { program_.parameters_unknown = true; }
    void set_definition(Span span) { program_.definition = span; }
    void declare(Variable variable, const Declaration& declaration) {
        program_.declarations.insert_or_assign(variable, declaration);
    }
    /// `name` stands for the variable.
    void add_alias(Variable name, Variable variable) { program_.aliases.emplace(name, variable); }
    /// The programs called from here see the variable, too.
    void hand_down(Variable variable) { program_.handed_down.push_back(variable); }

    // ---- expressions
    ExpressionId add(Expression expression);
    ExpressionId literal(double value, Span span) { return add({Literal{value, false}, span}); }
    ExpressionId unreadable(Span span) { return add({Unreadable{}, span}); }
    ExpressionId apply(Operation operation, std::span<const ExpressionId> operands, Span span);
    /// Gives an expression the span of what stands around it.
    ExpressionId widen(ExpressionId id, Span span);
    /// A literal number gets the other sign, and the span of both.
    ExpressionId negate_literal(ExpressionId id, Span span);
    [[nodiscard]] const Expression& expression(ExpressionId id) const { return program_.expressions[id]; }
    /// The number that the expression is; empty when it has to be calculated.
    [[nodiscard]] std::optional<double> literal_value(ExpressionId id) const;

    // ---- blocks
    void begin_block();
    /// `block` has all but its words and effects, which are those since begin_block().
    void end_block(Block block);
    /// Blocks that are not stored one by one; `net` is what they leave behind, `beside_codes` what stands
    /// beside codes.
    void add_run(PlainRun run, std::span<const ModalSetting> net, std::span<const CodeWords> beside_codes);

    // ---- what a block holds; between begin_block() and end_block()
    void add_word(Word word) { program_.words.push_back(word); }
    void add_effect(const Effect& effect) { effects_.push_back(effect); }
    /// Values that are computed and change nothing; none is no effect.
    void add_values(std::span<const ExpressionId> values, Span span);
    /// Values that are put out and variables that are taken in.
    void add_exchange(std::span<const ExpressionId> out, std::span<const Variable> in, Span span);
    void add_unreadable(const NamedInBlock& named, Span span);
    /// For Call::arguments.
    [[nodiscard]] Slice add_arguments(std::span<const Argument> arguments);
    /// A block that has ended gets the effects since begin_block(), and loses its own.
    void replace_effects(ItemId block);
    /// The block does nothing after all: it stands in a list for the operator.
    void drop_effects() { effects_.clear(); }
    /// How many effects the block has so far.
    [[nodiscard]] std::size_t effect_count() const { return effects_.size(); }
    /// Puts the effects from number `first` on under a condition.
    void guard(ExpressionId condition, std::size_t first, Span span);

  private:
    [[nodiscard]] Slice add_operands(std::span<const ExpressionId> operands);
    void end_section();

    Program program_;
    std::vector<Effect> effects_; ///< of the block
    Id first_word_ = 0;           ///< of the block
};

} // namespace maclint
