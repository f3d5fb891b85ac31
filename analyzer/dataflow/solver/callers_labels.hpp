//! Gathers the labels that a program names for its callers: many returns may name one.
#pragma once

#include "analyzer/dataflow/solver/summary.hpp"

namespace maclint::dataflow {

class CallersLabelSet {
  public:
    /// That of a return, where it names one and it is known which.
    void add(const Program& program, const Return& back);
    /// All that were added.
    [[nodiscard]] CallersLabels take();

  private:
    flow::LabelList numbers_;
    std::vector<std::string> names_;
};

/// All that the program's text names, reached or not.
[[nodiscard]] CallersLabels labels_named_for_callers(const Program& program);

/// What the labels are in a caller; a name that it lacks is that of no block. Nullptr: there are none.
/// Callers share the list of the numbers.
[[nodiscard]] std::shared_ptr<const flow::LabelList> labels_in(const Program& caller,
                                                               const CallersLabels& labels);

} // namespace maclint::dataflow
