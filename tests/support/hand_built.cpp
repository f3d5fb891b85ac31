//! Fills the model without a dialect.
#include "tests/support/hand_built.hpp"

#include "analyzer/program/call_kinds.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/program/variable_tables.hpp"

#include <utility>

namespace maclint::test {

const ControlModel& control_with_names() {
    static const ControlModel control = [] {
        ControlModel model{};
        model.name = "hand-built";
        model.language = "hand-built";
        model.spaces = {
            {"R parameter", "R", false, Scope::retained, InitialValue::old_value,
             "reference/sinumerik/fit.md 3"},
            {"local variable", "", true, Scope::frame, InitialValue::zero, "reference/sinumerik/fit.md 3"},
            {"parameter", "", true, Scope::frame, InitialValue::zero, "reference/sinumerik/fit.md 3"},
            {"global variable", "", true, Scope::retained, InitialValue::old_value,
             "reference/sinumerik/fit.md 3"},
        };
        ModalGroup diameter{};
        diameter.name = "diameter programming";
        diameter.letter = 'G';
        diameter.members = {{1, "DIAMOF"}, {2, "DIAMON"}};
        model.groups = {diameter};
        model.calls = {{"call by name", Frame::fresh, NestingLimit::subprogram, CallTrigger::once, 0, ""}};
        VariableRange parameters{};
        parameters.last = 99;
        parameters.meaning = Meaning::variable;
        parameters.space = rows::r;
        model.families = {{"R", {parameters}}};
        model.loops_left_by_jump = true;
        return model;
    }();
    return control;
}

HandBuilt::HandBuilt(std::string path, std::string text)
    : source_(std::make_shared<const Source>(Source::from_bytes(std::move(path), std::move(text))))
    , builder_(source_->path().substr(0, source_->path().find('.')), source_->bytes(), control_with_names()) {
    builder_.begin_section("program", Section::Executed::when_reached, {});
}

Variable HandBuilt::variable(SpaceId space, std::string_view name) {
    return {space, builder_.number_of_name(space, name)};
}

Variable HandBuilt::declare(std::string_view name, VariableType type) {
    const Variable declared = variable(rows::local, name);
    builder_.declare(declared, {type, std::nullopt, {}});
    return declared;
}

Variable HandBuilt::declare(std::string_view name, VariableType type, double initial) {
    const Variable declared = variable(rows::local, name);
    builder_.declare(declared, {type, initial, {}});
    return declared;
}

Variable HandBuilt::formal(std::string_view name, VariableType type, Passing passing) {
    const Variable parameter = variable(rows::parameter, name);
    builder_.add_formal({parameter, std::string(name), passing, {}});
    builder_.declare(parameter, {type, std::nullopt, {}});
    return parameter;
}

ExpressionId HandBuilt::number(double value) { return builder_.literal(value, {}); }
ExpressionId HandBuilt::load(Variable variable) { return builder_.add({Load{variable}, {}}); }
ExpressionId HandBuilt::load_at(ExpressionId index) {
    return builder_.add({LoadAt{rows::r_family, index}, {}});
}
ExpressionId HandBuilt::name(std::string_view label) {
    return builder_.add({builder_.block_name(label), {}});
}

ExpressionId HandBuilt::apply(Operation operation, std::initializer_list<ExpressionId> operands) {
    return builder_.apply(operation, std::span(operands.begin(), operands.size()), {});
}

void HandBuilt::end_block(Block block, std::initializer_list<Step> steps) {
    block.span = source_->line_span(++line_);
    builder_.begin_block();
    for (const Step& step : steps) {
        const std::size_t first = builder_.effect_count();
        builder_.add_effect({step.what, block.span});
        if (step.condition) builder_.guard(*step.condition, first, block.span);
    }
    builder_.end_block(block);
}

void HandBuilt::block(std::initializer_list<Step> steps) { end_block(Block{}, steps); }

void HandBuilt::labelled_block(std::string_view label, std::initializer_list<Step> steps) {
    Block block{};
    block.name = builder_.block_name(label);
    end_block(block, steps);
}

void HandBuilt::labelled_block(std::int64_t number, std::string_view label,
                               std::initializer_list<Step> steps) {
    Block block{};
    block.sequence_number = number;
    block.name = builder_.block_name(label);
    end_block(block, steps);
}

Call HandBuilt::call(std::string_view name, std::initializer_list<Argument> arguments) {
    const auto begin = static_cast<Offset>(builder_.program().text.find(name));
    const Slice slice = builder_.add_arguments(std::span(arguments.begin(), arguments.size()));
    return {Text{{begin, begin + static_cast<Offset>(name.size())}}, rows::by_name, slice, std::nullopt};
}

WorkspaceFile HandBuilt::finish() {
    auto file = std::make_shared<ProgramFile>();
    file->source = source_;
    file->control = &control_with_names();
    file->programs.push_back(builder_.take());
    return {std::move(file), true};
}

} // namespace maclint::test
