//! Names and calls, taken from the model.
#include "analyzer/workspace/outline.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>

namespace maclint {
namespace {

CallOutline outline_of(const Program& program, const Call& call) {
    CallOutline outline;
    outline.lookup = program.control->calls[call.kind].lookup;
    if (const auto* text = std::get_if<Text>(&call.program))
        outline.program = in_capitals(program.slice(text->characters));
    if (const auto* expression = std::get_if<ExpressionId>(&call.program)) {
        // What is unreadable stands for blocks of the program itself: M97, M98 Q.
        const bool own_blocks = std::holds_alternative<Unreadable>(program.expressions[*expression].node);
        if (const auto number = flow::constant_number(program, *expression))
            outline.program = *number;
        else if (!own_blocks)
            outline.program = ComputedName{};
    }
    return outline;
}

ProgramOutline outline_of(const Program& program) {
    ProgramOutline outline{.language = program.control->language,
                           .number = program.number,
                           .names = {in_capitals(program.name)},
                           .folder = in_capitals(program.folder),
                           .local = program.local,
                           .started_by_hand = program.started == Program::Started::by_hand,
                           .given_names = program.given_names,
                           .given_words = program.given_words,
                           .arrays =
                               program.given_names.empty() ? std::vector<ArrayDefinition>{} : program.arrays,
                           .calls = {}};
    // Names are compared without case: controls store capitals, file systems do not.
    for (const std::string& name : program.also_known_as) outline.names.push_back(in_capitals(name));
    std::ranges::sort(outline.names);
    outline.names.erase(std::ranges::unique(outline.names).begin(), outline.names.end());
    for_each_effect(program, [&](EffectId id) {
        if (const auto* call = std::get_if<Call>(&program.effects[id].what))
            outline.calls.push_back(outline_of(program, *call));
    });
    return outline;
}

} // namespace

FileOutline outline_of(const ProgramFile& file) {
    std::vector<ProgramOutline> programs;
    programs.reserve(file.programs.size());
    for (const Program& program : file.programs) programs.push_back(outline_of(program));
    return {file.source->path(), ProgramOutlines(std::move(programs)), file.control->code_system,
            file.machine_signs};
}

} // namespace maclint
