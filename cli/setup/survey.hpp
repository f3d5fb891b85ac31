//! What a folder of programs is made of, for `maclint init`.
#pragma once

#include "cli/config/settings.hpp"
#include "cli/notice.hpp"

#include <compare>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace maclint::cli {

/// What a program was taken for, and by what.
struct TakenFor {
    std::string dialect;
    std::string model;     ///< the control that maclint knows: "fanuc", "haas"
    bool is_lathe = false; ///< as its text is written
    char gcode_system = 0; ///< of a lathe that has them: 'A', 'B', 'C'
    friend auto operator<=>(const TakenFor&, const TakenFor&) = default;
};

struct SurveyedFile {
    std::string path; ///< from the folder, with '/'
    TakenFor taken_for;
    std::string model_reason; ///< marks of the control in the text; empty: assumed for the dialect
};

/// A file that is not linted.
struct OtherFile {
    std::string path, what;
};

struct Survey {
    std::vector<SurveyedFile> programs;           ///< by path
    std::vector<OtherFile> others;                ///< likewise
    std::vector<std::string> with_rights;         ///< programs of a maker, by path
    std::map<std::string, std::size_t> own_codes; ///< M codes that no table knows, and in how many files
    std::size_t called = 0;                       ///< programs that others of the folder call
    std::set<std::string> missing;                ///< programs that are called and are not there: "O9010"
    std::vector<Notice> notices;                  ///< on what could not be read
};

/// Of all programs in the folder and below it, as they are taken for without a configuration.
[[nodiscard]] Survey survey_of(const std::string& folder);

} // namespace maclint::cli
