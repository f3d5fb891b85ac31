//! Looks through blocks and plain runs for their numbers.
#include "analyzer/program/numbered_blocks.hpp"

#include "analyzer/program/overloaded.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace maclint {
namespace {

template<class Visit>
void visit_numbers(const Program& program, const Item& item, const Visit& visit) {
    std::visit(overloaded{[&](const Block& block) {
                              if (block.sequence_number)
                                  visit(*block.sequence_number, block.sequence_number_span);
                          },
                          [&](const PlainRun& run) {
                              if (!run.has_sequence_numbers) return;
                              program.for_each_block(run.span, [&](const PlainBlock& block) {
                                  if (block.sequence_number)
                                      visit(*block.sequence_number, block.sequence_number_span);
                                  return true;
                              });
                          }},
               item);
}

/// A literal block number.
std::optional<std::int64_t> number_of(const Program& program, ExpressionId expression) {
    const auto* literal = std::get_if<Literal>(&program.expressions[expression].node);
    constexpr double most = 1e9; // no control has block numbers of so many digits
    if (literal == nullptr || !(std::abs(literal->value) < most)) return std::nullopt;
    return std::llround(literal->value);
}

} // namespace

std::vector<BlockUser> find_block_users(const Program& program) {
    std::vector<BlockUser> users;
    for (EffectId id = 0; id < program.effects.size(); ++id) {
        const auto& what = program.effects[id].what;
        if (const auto* reference = std::get_if<Reference>(&what)) {
            const auto target = program.control->references[reference->kind].target;
            if (const auto number = number_of(program, reference->block))
                users.push_back({id, *number, target, false});
        }
        const auto* stop = std::get_if<Stop>(&what);
        if (stop != nullptr && stop->kind == Stop::Kind::restart && stop->number)
            if (const auto number = number_of(program, *stop->number))
                users.push_back({id, *number, SectionKind::Role::machining, true});
    }
    return users;
}

const SectionKind* kind_of(const ControlModel& control, const Section& section) {
    const auto row = std::ranges::find(control.sections, section.kind, &SectionKind::name);
    return row == control.sections.end() ? nullptr : &*row;
}

void index_block_numbers(ProgramFile& file) {
    for (std::uint32_t p = 0; p < file.programs.size(); ++p) {
        const Program& program = file.programs[p];
        for (std::uint32_t s = 0; s < program.sections.size(); ++s) {
            const Slice items = program.sections[s].items;
            for (Id i = items.first; i < items.first + items.count; ++i)
                visit_numbers(program, program.items[i], [&](std::int64_t number, Span span) {
                    file.block_numbers.push_back({number, span, p, s});
                });
        }
    }
    std::ranges::stable_sort(file.block_numbers, {}, &BlockNumber::number);
}

std::vector<NumberedBlock> find_blocks(const ProgramFile& file, const std::set<std::int64_t>& numbers) {
    std::vector<NumberedBlock> found;
    for (const std::int64_t number : numbers)
        for (const BlockNumber& block :
             std::ranges::equal_range(file.block_numbers, number, {}, &BlockNumber::number)) {
            const Program& program = file.programs[block.program];
            const SectionKind* kind = kind_of(*program.control, program.sections[block.section]);
            found.push_back({number, block.span, &program, kind});
        }
    return found;
}

} // namespace maclint
