//! What the analysis knows of one text, together with the programs that calls connect it with.
#pragma once

#include "analyzer/workspace/workspace.hpp"
#include "cli/lsp/mentions/mention.hpp"
#include "cli/lsp/server/session.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace maclint::cli::lsp {

class KnownValues {
  public:
    /// nullptr: the programs are too long for somebody who waits.
    [[nodiscard]] static std::unique_ptr<const KnownValues> of(Session& session,
                                                               const std::shared_ptr<const ReadText>& text);

    /// What is read or stored there: "5", "1 or 2", "from 0 to 10", "vacant"; empty where nothing is known.
    [[nodiscard]] std::string value_at(std::size_t program, const Mention& mention) const;
    /// What calls pass for it, as they write it, each once: "100.", "#5"; none: no call is known, or it is no
    /// argument.
    [[nodiscard]] std::vector<std::string> passed_for(std::size_t program, const Variable& variable) const;
    /// The numbers of the blocks that a computed jump can lead to; none: any.
    [[nodiscard]] std::vector<std::int64_t> targets_of(std::size_t program, EffectId jump) const;

  private:
    KnownValues(std::unique_ptr<const Workspace> workspace, const ProgramFile& file)
        : workspace_(std::move(workspace))
        , file_(file) {}
    [[nodiscard]] const ProgramAnalysis* analysis_of(std::size_t program) const;

    std::unique_ptr<const Workspace> workspace_; ///< holds the file
    const ProgramFile& file_;
};

} // namespace maclint::cli::lsp
