//! Entries for whole folders where all programs of a folder are alike: of single files each text decides.
#include "cli/setup/proposal.hpp"

#include "cli/report/columns.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

constexpr std::size_t most_named = 5; ///< files or codes of a comment
constexpr std::size_t widest_comment = 88;

std::string in_quotes(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Whether a glob would mean something else by the name.
bool has_wildcards(std::string_view name) { return name.find_first_of("*?[]!\\") != std::string_view::npos; }

/// "lathe" of "lathe/old/O1.nc"; empty for a file that lies in the folder itself.
std::string top_folder(const std::string& path) {
    const std::size_t slash = path.find('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
}

template<class List>
std::string some_of(const List& list) {
    std::string text;
    std::size_t count = 0;
    for (const std::string& one : list) {
        if (++count > most_named) break;
        text += (text.empty() ? "" : ", ") + shown(one);
    }
    if (list.size() > most_named) text += " and " + std::to_string(list.size() - most_named) + " more";
    return text;
}

std::string kind_in_words(const TakenFor& kind) {
    if (kind.dialect == "dinplus") return "DIN PLUS";
    std::string words = kind.model + (kind.is_lathe ? ", lathe" : "");
    if (kind.gcode_system != 0) words += std::string(", G code system ") + kind.gcode_system;
    return words;
}

/// What a glob is for: nothing where its programs differ.
using Kinds = std::map<std::string, std::optional<TakenFor>>;

/// A control of the shop with its own name.
struct ProposedControl {
    std::string name;
    TakenFor kind;
    std::vector<std::string> globs = {};
};

class Proposal {
  public:
    explicit Proposal(const Survey& survey)
        : survey_(survey) {
        find_controls();
    }

    std::string text() {
        add_kinds();
        line("{");
        // Keys in comments stand before others, so that none misses a comma when its mark is taken away.
        comment("Rules that the shop does not want, and severities: \"maclint rules\" lists them.");
        line("  // \"ignore\": [ \"MAC501\" ],");
        line("  // \"severity\": { \"MAC301\": \"warning\" },");
        add_complete();
        add_vendor();
        add_others();
        add_controls();
        add_files();
        line("}");
        drop_last_comma();
        return std::move(out_);
    }

  private:
    /// The FANUC-like programs of each folder below, or of the whole folder, as far as all are alike.
    void find_controls() {
        Kinds whole, folders;
        const auto note = [](Kinds& kinds, const std::string& glob, const TakenFor& kind) {
            const auto [entry, is_new] = kinds.try_emplace(glob, kind);
            if (!is_new && entry->second != kind) entry->second.reset();
        };
        for (const SurveyedFile& file : survey_.programs) {
            if (file.taken_for.dialect == "dinplus") continue;
            note(whole, "**", file.taken_for);
            const std::string folder = top_folder(file.path);
            if (!folder.empty() && !has_wildcards(folder)) note(folders, folder + "/**", file.taken_for);
        }
        const Kinds& kinds = !whole.empty() && whole.begin()->second ? whole : folders;
        for (const auto& [glob, kind] : kinds)
            if (kind) control_for_kind(*kind).globs.push_back(glob);
    }

    ProposedControl& control_for_kind(const TakenFor& kind) {
        const auto known = std::ranges::find(controls_, kind, &ProposedControl::kind);
        if (known != controls_.end()) return *known;
        std::string name = kind.is_lathe ? "Lathe" : "Mill";
        const auto same = std::ranges::count_if(
            controls_, [&](const ProposedControl& other) { return other.kind.is_lathe == kind.is_lathe; });
        if (same > 0) name += " " + std::to_string(same + 1);
        return controls_.emplace_back(ProposedControl{std::move(name), kind});
    }

    void add_kinds() {
        out_ += "// Written by 'maclint init'. Change what is wrong; 'maclint --show-config' prints what "
                "holds for each file.\n";
        std::map<TakenFor, std::size_t> counts;
        for (const SurveyedFile& file : survey_.programs) ++counts[file.taken_for];
        for (const auto& [kind, count] : counts)
            top_comment(counted(count, "file") + " taken for: " + kind_in_words(kind) + " (" +
                        first_of(kind) + ")");
        if (survey_.programs.empty()) top_comment("No NC programs were found here.");
    }

    /// A file of the kind, and why it was taken for that.
    [[nodiscard]] std::string first_of(const TakenFor& kind) const {
        const auto file = std::ranges::find(survey_.programs, kind, &SurveyedFile::taken_for);
        const std::string reason =
            file->model_reason.empty() ? "no program says which series" : file->model_reason;
        return shown(file->path) + (kind.dialect == "dinplus" ? "" : ": " + shown(reason));
    }

    void add_controls() {
        if (controls_.empty()) return;
        comment(
            "The controls of the shop. \"maclint controls\" lists the models that maclint knows: name yours, "
            "for instance fanuc-0i-d or fanuc-30i, so that its own limits and codes count.");
        line("  \"controls\": {");
        for (const ProposedControl& control : controls_) add_control(control, &control == &controls_.back());
        line("  },");
    }

    void add_control(const ProposedControl& control, bool is_last) {
        line("    " + in_quotes(control.name) + ": {");
        if (control.kind.is_lathe) {
            comment("By the codes that the programs have; without it each program's text decides.", "      ");
            line("      \"machine\": \"lathe\",");
            if (control.kind.gcode_system > 'A')
                line(std::string("      \"gcode-system\": \"") + control.kind.gcode_system + "\",");
        }
        if (!survey_.own_codes.empty() && &control == &controls_.front()) {
            std::vector<std::string> codes;
            for (const auto& [code, files] : survey_.own_codes) codes.push_back(code);
            comment("M codes of the machine that the programs have: " + some_of(codes) +
                        ". With \"codes\" any other that maclint does not know is told, so list all.",
                    "      ");
            std::string list;
            for (const std::string& code : codes) list += (list.empty() ? "" : ", ") + in_quotes(code);
            line("      // \"codes\": [ " + list + " ],");
        }
        line("      \"model\": " + in_quotes(model_of(control.kind)));
        line(is_last ? "    }" : "    },");
    }

    /// Of a lathe the model that the machine is told of beside.
    [[nodiscard]] static std::string model_of(const TakenFor& kind) {
        const std::size_t lathe = kind.model.find("-lathe");
        return kind.model.substr(0, lathe);
    }

    void add_files() {
        if (controls_.empty()) return;
        comment(
            "Which programs are for which control; of entries that take the same file the last one counts.");
        line("  \"files\": [");
        std::vector<std::string> entries;
        for (const ProposedControl& control : controls_)
            for (const std::string& glob : control.globs)
                entries.push_back("    { \"glob\": " + in_quotes(glob) +
                                  ", \"control\": " + in_quotes(control.name) + " }");
        for (std::size_t i = 0; i < entries.size(); ++i)
            line(entries[i] + (i + 1 < entries.size() ? "," : ""));
        line("  ],");
    }

    /// Folders without any program are left out; of single files it is only said.
    void add_others() {
        if (survey_.others.empty()) return;
        std::vector<std::string> folders, files;
        for (const OtherFile& other : survey_.others) {
            const std::string folder = top_folder(other.path);
            const bool has_programs = folder.empty() || has_wildcards(folder) ||
                                      std::ranges::any_of(survey_.programs, [&](const SurveyedFile& file) {
                                          return file.path.starts_with(folder + "/");
                                      });
            if (has_programs)
                files.push_back(other.path + " (" + other.what + ")");
            else if (std::ranges::find(folders, folder) == folders.end())
                folders.push_back(folder);
        }
        if (!files.empty()) comment("Not linted: " + some_of(files) + ".");
        if (folders.empty()) return;
        comment("Folders in which nothing is a program that maclint lints.");
        std::string list;
        for (const std::string& folder : folders) list += (list.empty() ? "" : ", ") + in_quotes(folder);
        line("  \"exclude\": [ " + list + " ],");
    }

    void add_vendor() {
        if (survey_.with_rights.empty()) return;
        comment("Programs that claim rights of a maker: " + some_of(survey_.with_rights) +
                ". Of these only errors count; false where they are your own.");
        line("  // \"vendor\": false,");
    }

    void add_complete() {
        if (survey_.called == 0 && survey_.missing.empty()) return;
        comment(survey_.missing.empty()
                    ? "All programs that are called by number are here (" + std::to_string(survey_.called) +
                          "). true where no program elsewhere calls one of them: more can be checked then."
                    : "Called, and not here: " + some_of(survey_.missing) +
                          ". true where every program of the control is in this folder.");
        line("  // \"complete\": true,");
    }

    /// Behind the last key that is no comment: not all readers of JSON take it.
    void drop_last_comma() {
        for (std::size_t end = out_.size(); end > 0;) {
            const std::size_t begin = out_.rfind('\n', end - 1) + 1; // 0 where there is none
            const std::string_view text = std::string_view(out_).substr(begin, end - begin);
            const std::size_t first = text.find_first_not_of(' ');
            const bool is_comment = first == std::string_view::npos || text.substr(first).starts_with("//");
            if (!is_comment && text.ends_with(',')) out_.erase(end - 1, 1);
            if (!is_comment && text != "}") return;
            if (begin == 0) return;
            end = begin - 1;
        }
    }

    void line(const std::string& text) { out_ += text + "\n"; }
    void comment(const std::string& text, const std::string& before = "  ") {
        const std::size_t room = widest_comment - before.size();
        for (const std::string& part : wrapped(text, room, room)) line(before + "// " + part);
    }
    void top_comment(const std::string& text) { comment(text, ""); }

    const Survey& survey_;
    std::vector<ProposedControl> controls_;
    std::string out_;
};

} // namespace

std::string proposed_configuration(const Survey& survey) { return Proposal(survey).text(); }

} // namespace maclint::cli
