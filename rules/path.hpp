//! Remarks that lead through a program: the jumps and branches of a path, the place where something came
//! from.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// The jumps and branches on this path, in execution order. Branches whose other side does not lead to the
/// path's end are left out; of the rest the last twelve are reported.
[[nodiscard]] std::vector<RelatedLocation> steps_along(const ProgramAnalysis& analysis,
                                                       std::span<const flow::EdgeId> path);

/// The steps along a shortest possible path between two nodes.
[[nodiscard]] std::vector<RelatedLocation> path_between(const ProgramAnalysis& analysis, flow::NodeId from,
                                                        flow::NodeId to);

/// The place that an origin stands for, with a text about it.
[[nodiscard]] RelatedLocation related_at(const ProgramAnalysis& analysis, dataflow::OriginId origin,
                                         std::string text);

/// A remark at an effect of the program.
[[nodiscard]] RelatedLocation related_at_effect(const ProgramAnalysis& analysis, EffectId effect,
                                                std::string text);

/// The same as the cause of a finding.
[[nodiscard]] Cause cause_at(const ProgramAnalysis& analysis, dataflow::OriginId origin);

/// The variable as it is written, with the letter of the argument that sets it in a macro: "#26 (Z)".
[[nodiscard]] std::string with_letter(const ProgramAnalysis& analysis, Variable variable);

/// Source text for a message: UTF-8, white space folded, 40 characters at most.
[[nodiscard]] std::string quoted(const Program& program, Span span);
[[nodiscard]] std::string quoted(std::string_view bytes);

/// A number as a word of a message: "0.5", "12".
[[nodiscard]] std::string number_word(double number);
/// A calculated length, in mm or inches, to four decimals: "7.0711".
[[nodiscard]] std::string length_word(double length);

/// 1-based line of a byte, as a word of a message.
[[nodiscard]] std::string line_number(const ProgramFile& file, Offset offset);

/// The program and the line: "O1000 line 12"; with the file where several programs have that name.
[[nodiscard]] std::string place_in(const ProgramAnalysis& analysis, Span span);

} // namespace maclint
