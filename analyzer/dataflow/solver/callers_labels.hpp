//! The labels that a program names for its callers (M99 P).
#pragma once

#include "analyzer/flow/graph.hpp"

#include <memory>

namespace maclint::dataflow {

/// Gathers them: many returns may name one.
class CallersLabels {
  public:
    /// That of a return, where it names one and it is known which.
    void add(const Program& program, const Return& back);
    /// All that were added, for the callers to share; nullptr: none.
    [[nodiscard]] std::shared_ptr<const flow::LabelList> take();

  private:
    flow::LabelList labels_;
};

/// All that the program's text names, reached or not; nullptr: none.
[[nodiscard]] std::shared_ptr<const flow::LabelList> labels_named_for_callers(const Program& program);

} // namespace maclint::dataflow
