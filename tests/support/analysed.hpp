//! Programs for tests: written as text in the test, read and analysed as the command does it.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::test {

/// A file of a test workspace: path and text.
using NamedText = std::pair<std::string, std::string>;

struct FolderOptions {
    bool complete; ///< no other program is on the control
    unsigned jobs;
    dataflow::FactSet facts = dataflow::FactSet::all(); ///< that are recorded
};

[[nodiscard]] std::unique_ptr<Workspace> analyse(std::vector<WorkspaceFile> files, FolderOptions options);
/// One program text of the dialect as a workspace of its own.
[[nodiscard]] std::unique_ptr<Workspace> analyse_text(std::string_view dialect, std::string text);
/// Several Fanuc or DIN PLUS files, the latter known by MACHINING or .ncs.
[[nodiscard]] std::unique_ptr<Workspace> analyse_files(const std::vector<NamedText>& files,
                                                       FolderOptions options);
/// The only program of a Fanuc text.
[[nodiscard]] std::unique_ptr<Workspace> analyse_fanuc(std::string text);

/// The first program of that name.
[[nodiscard]] const ProgramAnalysis& program(const Workspace& workspace, std::string_view name);

/// What the variable that a program reads last is known to be there.
[[nodiscard]] dataflow::Value last_read(const ProgramAnalysis& analysis);
/// The same of the program O0001 with this text.
[[nodiscard]] dataflow::Value last_read(const std::string& text);

/// What stands there in the program's file.
[[nodiscard]] std::string text_of(const ProgramAnalysis& analysis, Span span);
/// 1-based line of a byte of the program's file.
[[nodiscard]] std::uint32_t line_of(const ProgramAnalysis& analysis, Offset offset);
/// 1-based line of an effect.
[[nodiscard]] std::uint32_t line_of_effect(const ProgramAnalysis& analysis, EffectId effect);

} // namespace maclint::test
