//! Lists that are sorted once all is there.
#include "analyzer/dataflow/solver/callers_labels.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <utility>

namespace maclint::dataflow {
namespace {

template<class Value>
void keep_each_once(std::vector<Value>& values) {
    std::ranges::sort(values);
    const auto twice = std::ranges::unique(values);
    values.erase(twice.begin(), twice.end());
}

} // namespace

void CallersLabelSet::add(const Program& program, const Return& back) {
    const auto label = back.resume_label ? flow::constant_target(program, *back.resume_label) : std::nullopt;
    if (!label) return;
    if (std::holds_alternative<std::int64_t>(*label))
        numbers_.push_back(*label);
    else
        names_.push_back(program.spell(*label));
}

CallersLabels CallersLabelSet::take() {
    keep_each_once(numbers_);
    keep_each_once(names_);
    CallersLabels labels{nullptr, std::move(names_)};
    if (!numbers_.empty()) labels.numbers = std::make_shared<const flow::LabelList>(std::move(numbers_));
    return labels;
}

CallersLabels labels_named_for_callers(const Program& program) {
    CallersLabelSet labels;
    for_each_effect(program, [&](EffectId id) {
        if (const auto* back = std::get_if<Return>(&program.effects[id].what)) labels.add(program, *back);
    });
    return labels.take();
}

std::shared_ptr<const flow::LabelList> labels_in(const Program& caller, const CallersLabels& labels) {
    if (labels.names.empty()) return labels.numbers;
    constexpr std::int32_t of_no_block = -1;
    flow::LabelList list;
    if (labels.numbers) list = *labels.numbers;
    for (const std::string& name : labels.names)
        list.emplace_back(BlockName{caller.block_names.find(name).value_or(of_no_block)});
    keep_each_once(list);
    return std::make_shared<const flow::LabelList>(std::move(list));
}

} // namespace maclint::dataflow
