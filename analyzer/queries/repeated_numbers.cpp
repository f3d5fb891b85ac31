//! Groups numbered blocks by their numbers.
#include "analyzer/queries/repeated_numbers.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// The place that the jump takes, where it names a plain label.
std::optional<Span> taken_by(const ProgramAnalysis& analysis, EffectId jump) {
    const auto& jumps = analysis.graph().jumps;
    const auto found = std::ranges::find(jumps, jump, &flow::ResolvedJump::jump);
    return found == jumps.end() || !found->target ? std::nullopt : std::optional(found->target->span);
}

/// In the sections in which a reference or a restart is looked for.
void add_references(const ProgramAnalysis& analysis, std::vector<RepeatedNumber>& found) {
    using Wanted = std::pair<std::int64_t, SectionKind::Role>;
    std::map<Wanted, EffectId> users;
    std::set<std::int64_t> numbers;
    for (const BlockUser& user : find_block_users(analysis.program())) {
        users.emplace(Wanted(user.number, user.target), user.effect);
        numbers.insert(user.number);
    }
    std::map<Wanted, std::vector<Span>> places;
    for (const NumberedBlock& block : find_blocks(analysis.file(), numbers)) {
        if (block.section == nullptr) continue;
        const Wanted wanted(block.number, block.section->role);
        if (users.contains(wanted)) places[wanted].push_back(block.number_span);
    }
    for (auto& [wanted, blocks] : places)
        if (blocks.size() > 1)
            found.push_back(
                {wanted.first, std::move(blocks), users.at(wanted), taken_by(analysis, users.at(wanted))});
}

void add_jump_targets(const ProgramAnalysis& analysis, std::vector<RepeatedNumber>& found) {
    const auto& labels = analysis.graph().labels; // equal ones stand together
    for (auto first = labels.begin(); first != labels.end();) {
        const Label label = first->label;
        std::vector<Span> blocks;
        for (; first != labels.end() && first->label == label; ++first) blocks.push_back(first->span);
        const auto* number = std::get_if<std::int64_t>(&label);
        if (number == nullptr || blocks.size() == 1) continue;
        if (const auto user = analysis.user_of_label(label))
            found.push_back({*number, std::move(blocks), *user, taken_by(analysis, *user)});
    }
}

} // namespace

std::vector<RepeatedNumber> find_repeated_numbers(const ProgramAnalysis& analysis) {
    std::vector<RepeatedNumber> found;
    add_references(analysis, found);
    add_jump_targets(analysis, found);
    return found;
}

} // namespace maclint::queries
