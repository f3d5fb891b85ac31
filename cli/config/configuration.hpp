//! What a .maclint.json says.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/source/encoding.hpp"
#include "analyzer/source/source.hpp"
#include "analyzer/source/text_hash.hpp"
#include "analyzer/workspace/names_elsewhere.hpp"
#include "cli/config/glob_set.hpp"
#include "cli/config/own_control.hpp"
#include "cli/config/reach.hpp"
#include "cli/config/shop_words.hpp"
#include "cli/config/spacing_choice.hpp"
#include "cli/notice.hpp"
#include "rules/finding.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

namespace maclint::cli {

/// The name of the file that is looked for.
inline constexpr std::string_view configuration_name = ".maclint.json";

/// A word that names at least one rule.
struct RuleWord {
    std::string word;
    std::size_t source; ///< which of Configuration::sources it stands in
};

/// An entry of "files": what the matching files are written for.
struct FileEntry {
    Glob glob;
    std::string control; ///< empty: not said
    std::string dialect; ///< empty: not said
    std::size_t source;  ///< which of Configuration::sources it stands in
};

struct PerFileIgnore {
    Glob glob;
    std::vector<RuleWord> rules;
    std::size_t source; ///< which of Configuration::sources it stands in
};

struct SeverityEntry {
    RuleWord rules;
    Severity severity;
};

/// An entry of "vendor": "!own/**" says that what matches is no maker's.
struct VendorEntry {
    Glob glob;
    bool is_vendor;
    std::size_t source; ///< which of Configuration::sources it stands in
};

/// One configuration with what it extends.
struct Configuration {
    std::string path;            ///< as it is shown
    std::string folder;          ///< absolute
    std::vector<Source> sources; ///< the file itself, then those it extends
    std::unordered_map<std::string, std::shared_ptr<const OwnControl>, TextHash, std::equal_to<>> controls;
    std::vector<FileEntry> files;
    GlobSet files_by_glob; ///< in the order of `files`
    GlobSet include, exclude;
    std::vector<Glob> included; ///< what `include` is made of
    std::optional<std::vector<RuleWord>> select;
    std::vector<RuleWord> ignore;
    std::vector<SeverityEntry> severity;
    std::vector<PerFileIgnore> per_file_ignores;
    GlobSet ignores_by_glob; ///< in the order of per_file_ignores
    std::vector<VendorEntry> vendor;
    GlobSet vendor_by_glob;        ///< in the order of `vendor`
    bool vendor_by_remarks = true; ///< elsewhere the first remarks of a program tell
    std::optional<Encoding> encoding;
    ShopWords words;
    SpacingChoice spacing;
    bool complete = false;
    std::shared_ptr<const ListedNames> known_names; ///< nullptr: it lists none
    std::string baseline; ///< path as it is shown, from the working folder; empty: none
    std::map<std::string, std::size_t, std::less<>> source_of_key; ///< of what is not merged, by its key

    /// ".maclint.json: severity": which of the sources says it, and how, for people.
    [[nodiscard]] std::string said_in(std::size_t source, std::string_view how) const;
    /// Of a key that is not merged and that one of the sources has.
    [[nodiscard]] std::string said_in(std::string_view key) const;

    /// Of this configuration or of those built in, or nullptr.
    [[nodiscard]] const ControlModel* control(std::string_view name) const;
    /// The one built in that such a control is, or is made from: nothing is made.
    [[nodiscard]] const ControlModel* model_behind(std::string_view name) const;
    /// All names that `control` takes: those built in, then its own.
    [[nodiscard]] std::vector<std::string> known_controls() const;
};

/// Reads a configuration file and what it extends, all of which name only files within reach.
[[nodiscard]] std::variant<std::shared_ptr<const Configuration>, Notice>
load_configuration(const std::string& path, const Reach& reach);

/// Whether a text is JSON with a key of a configuration, by whatever name it is stored.
[[nodiscard]] bool looks_like_configuration(std::string_view text);

/// Whether a control runs what is written in the dialect.
[[nodiscard]] bool is_for(const ControlModel& control, const Dialect& dialect);

/// Names that "control" and --control may take besides those of a configuration.
[[nodiscard]] std::vector<std::string> control_names();
/// Names that "dialect" and --dialect may take besides "auto".
[[nodiscard]] std::vector<std::string> dialect_names();

} // namespace maclint::cli
