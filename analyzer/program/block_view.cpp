//! Questions about blocks that their runs answer without a look at each.
#include "analyzer/program/block_view.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <span>

namespace maclint {

bool moves(const Program& program, const Stretch& stretch) {
    const auto* run = std::get_if<PlainRun>(&program.items[stretch.item]);
    return run != nullptr && run->moves;
}

std::vector<ModalSetting> last_settings(const Program& program, const PlainRun& run, Span part) {
    std::vector<ModalSetting> last;
    blocks::visit_part(program, run, part, [&](const BlockView& block) {
        for (const BlockSetting& setting : block.settings) {
            std::erase_if(last, [&](const ModalSetting& known) { return known.group == setting.group; });
            last.push_back({setting.group, *setting.value});
        }
    });
    return last;
}

std::optional<BlockSetting> setting_of(const Program& program, const Effect& effect) {
    if (const auto* set = std::get_if<SetModal>(&effect.what)) {
        if (!set->group) return std::nullopt;
        const auto* literal = std::get_if<Literal>(&program.expressions[set->value].node);
        return BlockSetting{*set->group, literal == nullptr ? std::nullopt : std::optional(literal->value)};
    }
    const auto* call = std::get_if<Call>(&effect.what);
    if (call == nullptr) return std::nullopt;
    const CallKind& kind = program.control->calls[call->kind];
    const auto group = program.control->group_with(ModalRole::macro_call);
    if (kind.trigger == CallTrigger::once || !group) return std::nullopt;
    return BlockSetting{*group, kind.modal_code};
}

syntax::AddressSet addresses_named(const Program& program, std::string_view names) {
    if (names.empty()) return syntax::AddressSet::all();
    syntax::AddressSet set;
    if (program.plain_tables[0] == nullptr) return set;
    const auto& known = program.plain_tables[0]->names;
    const auto is_named = [&](std::string_view address) {
        for (std::size_t at = 0; (at = names.find(address, at)) != std::string_view::npos; ++at) {
            const std::size_t end = at + address.size();
            if ((at == 0 || names[at - 1] == ' ') && (end == names.size() || names[end] == ' ')) return true;
        }
        return false;
    };
    // An address without a name may be any.
    for (std::size_t id = 0; id < known.size(); ++id)
        if (known[id].empty() || is_named(known[id])) set.add(static_cast<syntax::AddressId>(id));
    return set;
}

std::size_t count_blocks(const Program& program) {
    std::size_t count = 0;
    for (const Item& item : program.items) {
        const auto* run = std::get_if<PlainRun>(&item);
        count += run == nullptr ? 1 : run->blocks;
    }
    return count;
}

std::optional<BlockView> last_block(const Program& program) {
    std::optional<BlockView> last;
    if (program.items.empty()) return last;
    blocks::visit_item(program, program.items.back(), [&](const BlockView& block) { last = block; });
    if (last) last->settings = {};
    return last;
}

} // namespace maclint
