//! Finds the lines by their letters, and asks what is in force only there.
#include "rules/words/arcs_going_on.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "rules/words/row_condition.hpp"
#include "rules/words/scanned.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

namespace maclint {
namespace {

bool is_whole(double number) { return std::floor(number) == number; }

} // namespace

ArcsGoingOn::ArcsGoingOn(const ProgramAnalysis& analysis, const RowIndex& index)
    : analysis_(analysis)
    , index_(index) {
    const ControlModel& control = analysis.control();
    const auto motion = control.group_with(ModalRole::motion);
    if (!motion || index.empty()) return;
    const ModalGroup& group = control.groups[*motion];
    for (const double circle : group.circles)
        for (const RowIndex::Entry& entry : index.rows_at({"G", Literal{circle, false}, false, {}})) {
            if (!goes_on_in_blocks(*entry.row->row)) continue;
            motion_ = motion;
            want(*entry.row->row);
            lines_.add_arc(circle);
            kinds_.add(scanned_kind(analysis.program().plain_tables[0], *entry.row));
        }
    for (const ModalMember& member : group.members)
        if (is_whole(member.number) && std::ranges::find(group.circles, member.number) == group.circles.end())
            lines_.add_other(member.number);
}

/// The letters by which a line can break the row.
void ArcsGoingOn::want(const WordRow& row) {
    for (const std::string_view word : words_of(row.words)) lines_.want(word.front());
    for (const std::string_view condition : words_of(row.when)) {
        const std::string_view address = condition_of(condition).address;
        lines_.move(address.front());
        addresses_.add(addresses_named(analysis_.program(), address));
    }
}

void ArcsGoingOn::for_each_line(const PlainRun& run, const std::function<void(Span)>& visit) {
    if (!motion_) return;
    if (run.words.addresses.meets(addresses_) && (in_arc_ || run.words.codes.meets(kinds_)))
        lines_.read(analysis_.program().text, run.span, in_arc_, visit);
    const auto& circles = analysis_.control().groups[*motion_].circles;
    for (const ModalSetting& setting :
         std::span(analysis_.program().settings).subspan(run.net.first, run.net.count))
        if (setting.group == *motion_) in_arc_ = std::ranges::find(circles, setting.value) != circles.end();
}

/// Whether the block has a code of the group, or one that may take the axes for itself.
bool ArcsGoingOn::names_motion(const queries::WordsOfBlock& block) const {
    return std::ranges::any_of(block.words, [&](const Word& word) {
        const auto* literal = std::get_if<Literal>(&word.value);
        if (word.address != "G") return false;
        const Word target{"X", Literal{0, false}, false, {}};
        return literal == nullptr || analysis_.control().group_of('G', literal->value) == motion_ ||
               queries::may_belong_to_another(block, target, target);
    });
}

void ArcsGoingOn::look_at(const queries::WordsOfBlock& block, RowPass& pass) {
    if (!motion_) return;
    const auto& circles = analysis_.control().groups[*motion_].circles;
    const bool is_run = block.block.effects.count == 0;
    const bool may_go_on = in_arc_ || is_run;
    for (const BlockSetting& setting : block.block.settings)
        if (!is_run && setting.group == *motion_)
            in_arc_ = setting.value && std::ranges::find(circles, *setting.value) != circles.end();
    if (!may_go_on || block.modal_calls || names_motion(block)) return;
    queries::BlockModes modes = block.modes_at(block.block);
    const queries::Modes now = modes.with_words(*motion_);
    if (!now.is_surely_one_of(circles) || now.possible.front() == told_) return;
    const ControlModel& control = analysis_.control();
    const auto cycle = control.group_with(ModalRole::cycle);
    if (cycle && control.groups[*cycle].cancel &&
        !modes.with_words(*cycle).is_surely_one_of({&*control.groups[*cycle].cancel, 1}))
        return;
    if (pass.look_at_arc(block, index_, *motion_, now.possible.front())) told_ = now.possible.front();
}

} // namespace maclint
