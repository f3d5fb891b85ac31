//! The dialects that maclint reads, the controls it knows, and which of them a file is for.
#pragma once

#include "analyzer/program/tables.hpp"
#include "analyzer/source/source.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace maclint {

struct LanguageTables; // language_words.hpp
struct ProgramFile;

/// How much of a text is read.
enum class Extent : std::uint8_t {
    whole,
    names_and_calls, ///< blocks that neither name nor call a program are passed over: enough to tell which
                     ///< programs belong together
};

/// One dialect: how its files are recognised and turned into programs.
struct Dialect {
    std::string_view name; ///< what --dialect takes
    std::string_view description;
    std::string_view default_control;             ///< the control assumed when nobody names one
    std::string_view comment_open, comment_close; ///< for suppressions and examples
    ProgramFile (*read)(std::shared_ptr<const Source>, const ControlModel&, Extent);
    LanguageTables (*words)(); ///< what its words mean, for people and editors
};

[[nodiscard]] std::span<const Dialect> dialects();
[[nodiscard]] const Dialect* find_dialect(std::string_view name);

/// All controls, of all dialects; names are unique.
[[nodiscard]] std::span<const ControlModel* const> controls();
[[nodiscard]] const ControlModel* find_control(std::string_view name);

/// What a file's extension and content say. Without a dialect the file is not ours: `reason` says what it is.
struct Detection {
    const Dialect* dialect;
    std::string reason; ///< "extension .nc", "HEIDENHAIN Klartext (BEGIN PGM on line 1)"
    bool not_nc_text; ///< no NC program of any kind (binary, C, JSON, noise): MAC003 when the user named the
                      ///< file
    bool certain;     ///< the text bears marks of the dialect; else nothing in it speaks for another
    std::string_view control = {};   ///< that the text bears marks of; empty: none
    std::string control_reason = {}; ///< "'#30003.036' on line 5"
};
[[nodiscard]] Detection detect_dialect(const Source& source);

/// Whether the beginning of a text that has no name to go by is plainly that of a program of ours: it bears
/// marks of a dialect, or blocks follow a tape mark.
[[nodiscard]] bool is_plainly_a_program(std::string_view beginning);

/// Whether a file with this name is worth opening when a folder is searched.
[[nodiscard]] bool has_nc_extension(std::string_view path);
/// Whether it is news that a file of a searched folder is no NC text; it is none of a README.txt, of a
/// C header among Klartext programs.
[[nodiscard]] bool is_worth_a_note(std::string_view path);

} // namespace maclint
