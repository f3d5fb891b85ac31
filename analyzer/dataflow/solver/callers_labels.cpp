//! A list that is sorted once all is there.
#include "analyzer/dataflow/solver/callers_labels.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <utility>

namespace maclint::dataflow {

void CallersLabels::add(const Program& program, const Return& back) {
    const auto label = back.resume_label ? flow::constant_target(program, *back.resume_label) : std::nullopt;
    // A name is numbered by each program for itself.
    if (label && std::holds_alternative<std::int64_t>(*label)) labels_.push_back(*label);
}

std::shared_ptr<const flow::LabelList> CallersLabels::take() {
    if (labels_.empty()) return nullptr;
    std::ranges::sort(labels_);
    const auto twice = std::ranges::unique(labels_);
    labels_.erase(twice.begin(), twice.end());
    return std::make_shared<const flow::LabelList>(std::move(labels_));
}

std::shared_ptr<const flow::LabelList> labels_named_for_callers(const Program& program) {
    CallersLabels labels;
    for_each_effect(program, [&](EffectId id) {
        if (const auto* back = std::get_if<Return>(&program.effects[id].what)) labels.add(program, *back);
    });
    return labels.take();
}

} // namespace maclint::dataflow
