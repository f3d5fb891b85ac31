//! Collects the blocks of a file in programs and sections.
#pragma once

#include "analyzer/dialect/dinplus/open_program.hpp"
#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/program/builder.hpp"
#include "analyzer/program/model.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::dinplus {

/// The programs of a file: the main part and its local subprograms. After a subprogram any other section
/// word goes on with the main part.
class Programs {
  public:
    Programs(const Source& source, const ControlModel& control, ProgramFile& file)
        : source_(source)
        , control_(control)
        , file_(file) {}

    /// `%shaft.nc "TURN_V1.0"`: the first line of a file. `mark` is where the '%' stands.
    void open_main(Span line, Offset mark);
    /// A section word in the line `heading`.
    void open_section(const SectionWord& word, Span heading);
    /// Where the next block belongs.
    [[nodiscard]] OpenProgram& current();
    /// The program of current(), if there is one already.
    [[nodiscard]] const OpenProgram* current_if_any() const;
    /// At the end of the file.
    void close();

  private:
    OpenProgram& open(std::string name);
    OpenProgram& main();
    void open_subprogram(const SectionWord& word, Span heading);
    void begin_section(const SectionKind& kind, Span heading);
    void leave_section();
    [[nodiscard]] std::shared_ptr<const VariablesByName> inherited(const OpenProgram& main);
    void check_length(std::string_view name);
    void check_language(const SectionWord& word, Span heading);

    static constexpr std::size_t nothing = SIZE_MAX;

    const Source& source_;
    const ControlModel& control_;
    ProgramFile& file_;
    std::vector<OpenProgram> open_; ///< one for each program of the file
    std::size_t main_ = nothing;
    // What subprograms have inherited last, from which program, and how many names that had declared by then.
    std::shared_ptr<const VariablesByName> inherited_;
    std::shared_ptr<const VariablesByName> of_main_; ///< all of them
    std::size_t inherited_from_ = nothing, inherited_of_ = 0;
    std::size_t current_ = nothing;
    std::optional<SectionWord::Use> language_; ///< of the section words so far
};

} // namespace maclint::dinplus
