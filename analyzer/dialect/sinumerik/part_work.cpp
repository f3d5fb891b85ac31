//! Goes through the blocks of a part and adds up.
#include "analyzer/dialect/sinumerik/part_work.hpp"

#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <span>
#include <variant>

namespace maclint::sinumerik {
namespace {

void add(std::vector<Variable>& list, Variable variable) {
    if (std::ranges::find(list, variable) == list.end()) list.push_back(variable);
}

class Reader {
  public:
    Reader(const Program& program, const std::function<bool(const Label&)>& stays_inside)
        : program_(program)
        , stays_inside_(stays_inside) {}

    void read(ItemId item) {
        const auto read_words = [this](const BlockView&, std::span<const Word> words) {
            for (const Word& word : words) read_word(word);
        };
        for_each_block_with_words(program_, Stretch{item, program_.span_of(item)}, read_words);
        std::visit([this](const auto& blocks) { read_blocks(blocks); }, program_.items[item]);
    }

    PartWork take() {
        if (depth_ != 0) work_.may_do_anything = true; // the end of a loop looks for its beginning elsewhere
        if (work_.may_do_anything) work_.in_a_row = false;
        work_.handles_machine |= switches_coolant_ && !work_.moves;
        return std::move(work_);
    }

  private:
    void read_blocks(const PlainRun& run) {
        for (Id i = run.net.first; i < run.net.first + run.net.count; ++i)
            work_.groups[program_.settings[i].group] = program_.settings[i].value;
        work_.moves |= run.moves;
    }

    void read_blocks(const Block& block) {
        if (block.skip_levels != 0) work_.in_a_row = false;
        read_effects(block.effects);
    }

    /// What is set of the machine beside modal groups.
    void read_word(const Word& word) {
        const MachineWords& machine = *program_.control->machine_words;
        work_.handles_machine |= word.address == "T" || word.address == machine.clamp_address;
        if (word.address != "M") return;
        const auto* number = std::get_if<Literal>(&word.value);
        const bool is_coolant = number != nullptr && (number->value == machine.coolant_off ||
                                                      std::ranges::find(machine.coolant_on, number->value) !=
                                                          machine.coolant_on.end());
        switches_coolant_ |= is_coolant;
        work_.handles_machine |= number == nullptr || !(is_coolant || acts_on_flow(number->value) ||
                                                        program_.control->group_of('M', number->value));
    }

    void read_effects(Slice effects) {
        for (const Effect& effect : program_.effects_in(effects))
            std::visit([this](const auto& what) { read_effect(what); }, effect.what);
    }

    void read_effect(const Assign& what) {
        read_value(what.value);
        if (const auto* variable = std::get_if<Variable>(&what.target))
            add(work_.written, *variable);
        else if (std::holds_alternative<StoreAt>(what.target))
            work_.may_do_anything = true;
    }
    void read_effect(const SetModal& what) {
        read_value(what.value);
        const auto* number = std::get_if<Literal>(&program_.expressions[what.value].node);
        if (what.group)
            work_.groups[*what.group] = number == nullptr ? std::nullopt : std::optional(number->value);
        else
            work_.may_do_anything = true;
    }
    void read_effect(const EvaluateWords& what) { read_values(program_.values_of(what)); }
    void read_effect(const Motion& /*what*/) { work_.moves = true; }
    void read_effect(const Synchronise& /*what*/) { work_.stops_look_ahead = true; }
    void read_effect(const ToolChange& /*what*/) { work_.handles_machine = true; }
    void read_effect(const Stop& what) { work_.may_do_anything |= what.kind != Stop::Kind::pause; }
    void read_effect(const Guarded& what) {
        work_.in_a_row = false;
        read_value(what.condition);
        read_effects(what.effects);
    }
    void read_effect(const RegionMark& what) {
        work_.in_a_row = false;
        if (what.condition) read_value(*what.condition);
        if (what.part == RegionMark::Part::open) ++depth_;
        if (what.part == RegionMark::Part::close) --depth_;
        if (depth_ < 0) work_.may_do_anything = true;
    }
    void read_effect(const Jump& what) {
        work_.in_a_row = false;
        const auto* name = std::get_if<BlockName>(&program_.expressions[what.target].node);
        if (name == nullptr || !stays_inside_(*name)) work_.may_do_anything = true;
    }
    void read_effect(const Call& what) {
        for (const Argument& argument : program_.arguments_of(what)) {
            read_value(argument.value);
            if (const auto* load = std::get_if<Load>(&program_.expressions[argument.value].node))
                add(work_.written, load->variable);
        }
        if (program_.control->calls[what.kind].brought_by_control)
            work_.moves = true;
        else
            work_.may_do_anything = true;
    }
    void read_effect(const Exchange& what) {
        read_values(program_.values_of(what));
        for (const Variable variable : program_.variables_of(what)) add(work_.written, variable);
    }
    void read_effect(const Return& /*what*/) { work_.may_do_anything = true; }
    void read_effect(const UnreadableBlock& what) {
        for (const Variable variable : program_.variables_of(what)) add(work_.written, variable);
        work_.may_do_anything = true;
    }
    void read_effect(const Reference& /*what*/) {}

    void read_values(std::span<const ExpressionId> values) {
        for (const ExpressionId value : values) read_value(value);
    }

    void read_value(ExpressionId value) {
        const auto& node = program_.expressions[value].node;
        if (const auto* load = std::get_if<Load>(&node)) add(work_.read, load->variable);
        if (const auto* element = std::get_if<LoadAt>(&node)) read_value(element->index);
        if (const auto* apply = std::get_if<Apply>(&node)) read_values(program_.operands_of(*apply));
    }

    const Program& program_;
    const std::function<bool(const Label&)>& stays_inside_;
    PartWork work_;
    bool switches_coolant_ = false;
    int depth_ = 0; ///< of loops and choices that the part has opened
};

} // namespace

PartWork work_of(const Program& program, Part part, const std::function<bool(const Label&)>& stays_inside) {
    Reader reader(program, stays_inside);
    for (ItemId item = part.first; item <= part.last; ++item) reader.read(item);
    return reader.take();
}

} // namespace maclint::sinumerik
