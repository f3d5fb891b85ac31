//! Looks through blocks and plain runs for their numbers.
#include "analyzer/program/numbered_blocks.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace maclint {
namespace {

/// A literal block number.
std::optional<std::int64_t> number_of(const Program& program, ExpressionId expression) {
    const auto* literal = std::get_if<Literal>(&program.expressions[expression].node);
    constexpr double most = 1e9; // no control has block numbers of so many digits
    if (literal == nullptr || !(std::abs(literal->value) < most)) return std::nullopt;
    return std::llround(literal->value);
}

/// The numbers that something names.
struct Named {
    std::vector<std::int64_t> numbers; ///< sorted

    bool operator()(std::int64_t number) const { return std::ranges::binary_search(numbers, number); }
    [[nodiscard]] bool between(std::int64_t lowest, std::int64_t highest) const {
        const auto from = std::ranges::lower_bound(numbers, lowest);
        return from != numbers.end() && *from <= highest;
    }
};

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
    Named named;
    for (const Program& program : file.programs)
        for (const BlockUser& user : find_block_users(program)) named.numbers.push_back(user.number);
    std::ranges::sort(named.numbers);
    for (std::uint32_t p = 0; p < file.programs.size(); ++p) {
        const Program& program = file.programs[p];
        for (std::uint32_t s = 0; s < program.sections.size(); ++s)
            for_each_numbered_block(program, program.sections[s], named, [&](const BlockView& block) {
                file.block_numbers.push_back({*block.number, block.number_span, p, s});
            });
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
