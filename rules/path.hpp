//! Remarks that lead through a program: the jumps and branches of a way, the place where something came from.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"

#include <string>
#include <vector>

namespace maclint {

/// The jumps and branches on a shortest possible way between two nodes, in execution order; at most twelve.
[[nodiscard]] std::vector<Remark> way_between(const ProgramAnalysis& analysis, flow::NodeId from,
                                              flow::NodeId to);

/// The place that an origin stands for, with a text about it.
[[nodiscard]] Remark remark_at(const ProgramAnalysis& analysis, dataflow::OriginId origin, std::string text);

/// A remark at an effect of the program.
[[nodiscard]] Remark remark_at_effect(const ProgramAnalysis& analysis, EffectId effect, std::string text);

/// Source text for a message: UTF-8, white space folded, 40 characters at most.
[[nodiscard]] std::string quoted(const Program& program, Span span);

/// 1-based line of a byte, as a word of a message.
[[nodiscard]] std::string line_number(const ProgramFile& file, Offset offset);

} // namespace maclint
