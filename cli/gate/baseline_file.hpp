//! The file that known findings are kept in; docs/baseline.md describes it.
#pragma once

#include "cli/notice.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace maclint::cli {

/// What a finding is known again by.
struct KnownPlace {
    std::string file; ///< see name_in_baseline
    std::string rule; ///< its code, with the key of the row that found it: "MAC303", "MAC523/G83.Q"
    std::string fingerprint;

    friend auto operator<=>(const KnownPlace&, const KnownPlace&) = default;
};

struct BaselineEntry {
    KnownPlace place;
    std::size_t count = 1; ///< of findings that are alike
    std::string block;     ///< for people: what stood there
};

/// In the order of files, rules and fingerprints, each place once.
using Baseline = std::vector<BaselineEntry>;

enum class NamedBy : std::uint8_t {
    command_line,  ///< it may be a pipe
    configuration, ///< it is a file: many are found, and each pipe would be waited for
};

/// In that order, and entries of one place as one, whatever a merge made of the file. What is wrong with it
/// ends the run.
[[nodiscard]] std::variant<Baseline, Notice> read_baseline(const std::string& path, NamedBy named_by);

/// The text of the file: sorted, a line an entry.
[[nodiscard]] std::string baseline_text(Baseline baseline);

/// Whether there is a file that a baseline was written to, whole or not.
[[nodiscard]] bool holds_baseline(const std::string& path);

/// The name that a baseline in `folder`, which is canonical, has for a file: relative to the folder, with
/// '/'. What is no UTF-8, and '%', is written as %XX.
[[nodiscard]] std::string name_in_baseline(const std::string& path, const std::string& folder);
/// Back to a path: absolute.
[[nodiscard]] std::string path_of_name(std::string_view name, const std::string& folder);
/// The folder of a baseline, canonical.
[[nodiscard]] std::string folder_of_baseline(const std::string& path);

} // namespace maclint::cli
