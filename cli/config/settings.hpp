//! What holds for each file: the command line over the configuration over what maclint assumes.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "cli/config/configuration.hpp"
#include "cli/config/machine_facts.hpp"
#include "cli/config/selection.hpp"
#include "cli/input/size_limits.hpp"
#include "cli/notice.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace maclint::cli {

/// What the command line says about rules, dialect and configuration. Its words have been checked.
struct Overrides {
    const Dialect* dialect = nullptr; ///< nullptr: the configuration says, or the file shows it
    std::string control;              ///< empty: the configuration says
    MachineFacts machine = {};        ///< of all files' machine, beside what the configuration says
    std::vector<std::string>
        select; ///< empty: the configuration says; else it replaces its select and ignore
    std::vector<std::string> ignore;
    std::vector<std::pair<std::string, Severity>> severity;
    std::string config_path;       ///< --config; empty: the nearest one upward from each file
    bool isolated = false;         ///< no configuration at all
    bool complete = false;         ///< every program of the control is there, whatever the configuration says
    std::string baseline;          ///< --baseline; empty: the configuration says
    bool no_baseline = false;      ///< none at all
    bool vendor = false;           ///< all findings in a maker's programs count
    bool named_are_vendor = false; ///< in files that are named, too, warnings and notes in them do not
    std::uintmax_t max_file_size = usual_program_bytes; ///< in bytes; a larger program is not read
};

/// A control that somebody named, and where.
struct NamedControl {
    const ControlModel* control;
    std::string reason; ///< "--control", ".maclint.json: files '*.nc'"

    [[nodiscard]] std::string_view language() const { return control->language; }
};

/// Which programs of a file are taken for a maker's.
enum class VendorCode : std::uint8_t {
    none,       ///< none, or somebody wants to see their findings
    by_remarks, ///< those whose first remarks claim rights
    whole_file, ///< all: the configuration says so
};

struct FileSettings {
    std::shared_ptr<const Configuration> configuration; ///< nullptr: none
    const Dialect* dialect = nullptr;                   ///< nullptr: the file's content decides
    std::string dialect_reason;
    std::vector<NamedControl> controls; ///< what counts most comes first; each for files of its language only
    std::shared_ptr<const RuleStates> rules;
    bool complete = false; ///< every program of the control is there
    VendorCode vendor = VendorCode::by_remarks;
    std::string baseline;                               ///< path of the file that knows findings; empty: none
    std::uintmax_t max_file_size = usual_program_bytes; ///< in bytes; a larger file is not read
};

/// Finds settings and remembers what many files share. For one thread.
class Settings {
  public:
    /// `own`: folders in which configurations may name what they like, see own_folders.
    explicit Settings(Overrides overrides, std::vector<std::filesystem::path> own = {})
        : overrides_(std::move(overrides))
        , own_(std::move(own)) {}

    /// Nothing when the configuration that holds for the file is wrong; see take_notices.
    [[nodiscard]] std::optional<FileSettings> for_file(const std::string& path);
    /// Whether warnings and notes in a maker's programs count in files that the user names.
    [[nodiscard]] bool named_show_all() const { return !overrides_.named_are_vendor; }
    /// The configuration that holds in a folder, or nullptr; nothing when it is wrong.
    [[nodiscard]] std::optional<std::shared_ptr<const Configuration>> for_folder(const std::string& folder);

    /// All configurations that were used so far, in the order of their paths.
    [[nodiscard]] std::vector<std::shared_ptr<const Configuration>> configurations() const;
    /// What is wrong with configurations that were met since the last call.
    [[nodiscard]] std::vector<Notice> take_notices();

  private:
    using Loaded = std::optional<std::shared_ptr<const Configuration>>;
    Loaded load(const std::string& path, const Reach& reach);
    /// The one of the folder, by the name that it is shown by, or of those above it.
    Loaded in_folder(const std::filesystem::path& folder, const std::string& shown);
    [[nodiscard]] std::optional<Notice> refuse_link(const std::filesystem::path& folder,
                                                    const std::string& shown) const;
    void tell_of_machine(FileSettings& settings);
    [[nodiscard]] const ControlModel& with_machine(const ControlModel& control);
    static void say_of_file(const Configuration& configuration, const std::string& path,
                            FileSettings& settings);
    [[nodiscard]] static VendorCode vendor_code(const Configuration* configuration, const std::string& path);
    void note_owner(const std::string& path);
    void note_above(const Configuration& configuration, const std::filesystem::path& folder);
    /// Where a file of the folder was meant for a configuration by another name.
    void note_other_names(const std::filesystem::path& folder, const std::string& shown);
    void note_once(const std::string& path, const std::string& message, NoticeKind kind);
    /// Without what single files go without.
    std::shared_ptr<const RuleStates> whole_rules(const Configuration* configuration);
    std::shared_ptr<const RuleStates> rules_for(const Configuration* configuration, const std::string& path);
    void apply_overrides(RuleStates& rules) const;

    Overrides overrides_;
    std::vector<std::filesystem::path> own_;
    std::map<const ControlModel*, std::unique_ptr<ControlModel>> with_machine_; ///< and their lathes
    std::map<std::string, Loaded> by_folder_;
    std::map<std::string, Loaded> by_path_;
    /// By the entries of "per-file-ignores" that hold.
    std::map<std::pair<const Configuration*, std::vector<std::size_t>>, std::shared_ptr<const RuleStates>>
        rule_states_;
    std::vector<Notice> notices_;
    std::set<std::pair<std::string, std::string>> noted_;
};

/// The first of the controls that is for the dialect's language; nullptr: what the dialect assumes.
[[nodiscard]] const NamedControl* control_for(const Dialect& dialect,
                                              const std::vector<NamedControl>& controls);

} // namespace maclint::cli
