//! Collects the blocks of a file in programs.
#pragma once

#include "analyzer/dialect/sinumerik/open_program.hpp"
#include "analyzer/source/source.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::sinumerik {

/// The programs of a file: one, or those of an archive.
class Programs {
  public:
    Programs(const Source& source, const ControlModel& control, ProgramFile& file)
        : source_(source)
        , control_(control)
        , file_(file) {}

    /// `%_N_SHAFT_MPF` in front of a program [NCP19 p.43]. `mark` is where the '%' stands.
    void open_behind(Span line, Offset mark);
    /// Where the next block belongs.
    [[nodiscard]] OpenProgram& current();
    [[nodiscard]] bool is_in_foreign_language() const {
        return !open_.empty() && open_.back().foreign_language;
    }
    /// At the end of the file.
    void close();

  private:
    void open(std::string written);
    void check_labels(const OpenProgram& program);
    void collect_names(OpenProgram& program);

    const Source& source_;
    const ControlModel& control_;
    ProgramFile& file_;
    std::vector<OpenProgram> open_; ///< the last one takes the next block
};

} // namespace maclint::sinumerik
