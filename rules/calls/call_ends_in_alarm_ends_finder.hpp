//! Where a program ends that is begun in one way.
#pragma once

#include "analyzer/dataflow/solver/analysis.hpp"
#include "rules/calls/call_ends_in_alarm_finder.hpp"

#include <optional>

namespace maclint::rules {

/// The nearest alarm behind the node, over at most so many levels of calls; nothing where none is found.
[[nodiscard]] std::optional<AlarmReached> nearest_alarm(const ProgramAnalysis& analysis,
                                                        const dataflow::Analysis& begun, flow::NodeId start,
                                                        int levels);

/// The nearest test at which the program, begun so, has no way but to the alarm, while it may come back from
/// there if it is begun otherwise.
[[nodiscard]] std::optional<flow::NodeId> last_test(const ProgramAnalysis& called,
                                                    const dataflow::Analysis& begun);

/// A shortest path to the node, from the start.
[[nodiscard]] std::vector<flow::EdgeId> path_to(const ProgramAnalysis& called,
                                                const dataflow::Analysis& begun, flow::NodeId node);

} // namespace maclint::rules
