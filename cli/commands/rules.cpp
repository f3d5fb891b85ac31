//! `maclint rules`: the list, and the pages of the documentation.
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/source.hpp"
#include "cli/commands/commands.hpp"
#include "cli/config/selection.hpp"
#include "cli/options/help.hpp"
#include "cli/report/alarm_page.hpp"
#include "cli/report/code_page.hpp"
#include "cli/report/row_page.hpp"
#include "cli/report/rule_json.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/terminal.hpp"

#include <algorithm>
#include <filesystem>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

std::string text_list() {
    const std::size_t width = output_width();
    return plain_list(all_rules(), ListedRows::shown, width) + "\n" +
           paragraph(
               "Off: only with --select. A row is named with its rule, as MAC523/G83.Q. 'maclint explain "
               "RULE' tells more.",
               width);
}

/// "MAC303.md", and not "MACHINES.md".
bool is_page_name(std::string_view name) {
    constexpr std::size_t digits = 3;
    if (!name.ends_with(".md") ||
        !(name.starts_with("MAC") || name.starts_with("DIN") || name.starts_with("SIN")))
        return false;
    const std::string_view number = name.substr(3, name.size() - 6);
    return number.size() == digits && number.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Pages of rules that are gone, so that the folder shows what there is.
void remove_old_pages(const fs::path& folder) {
    std::error_code ignored;
    for (const auto& entry : platform::entries_of(folder, ignored)) {
        const std::string name = platform::text_of(entry.path.filename());
        if (is_page_name(name) && find_rule(name.substr(0, 6)) == nullptr) fs::remove(entry.path, ignored);
    }
}

/// Whether everything in the folder may be replaced: it is empty, or its index says that it was written here.
bool is_ours(const fs::path& folder, std::string_view mark) {
    std::error_code error;
    if (platform::entries_of(folder, error).empty()) return true; // writing says if it is none
    const auto index = Source::read_file(platform::text_of(folder / index_name));
    const auto* source = std::get_if<Source>(&index);
    return source != nullptr && source->bytes().find(mark) != std::string_view::npos;
}

/// The page with what only a page beside the others can have: its rows, which are many, and a link to the
/// table of sources.
std::string written_page(const Rule& rule) {
    std::string page = markdown_page(rule) + markdown_rows(rule);
    if (!rule.sources.empty()) page += "\n[What the keys stand for](../sources.md)\n";
    return page;
}

/// Makes the folder; false, with a word to the user, where it holds what `option` did not write.
bool take_folder(const fs::path& path, std::string_view mark, std::string_view option) {
    std::error_code ignored;
    fs::create_directories(path, ignored);
    if (is_ours(path, mark)) return true;
    print_notice({NoticeKind::unreadable, platform::text_of(path),
                  "this folder holds files, and no " + std::string(index_name) + " that " +
                      std::string(option) + " wrote. Name an empty folder."});
    return false;
}

int write_codes(const std::string& folder) {
    for (const std::string_view language : languages_of_chapters()) {
        const fs::path path = platform::path_of(folder) / platform::path_of(std::string(language));
        if (!take_folder(path, codes_mark, "--write-codes")) return exit_error;
        std::error_code ignored;
        for (const auto& entry : platform::entries_of(path, ignored))
            if (platform::text_of(entry.path.filename()).ends_with(".md")) fs::remove(entry.path, ignored);
        auto failure = write_to(platform::text_of(path / index_name), markdown_codes(language));
        for (const CodeBook* book : books_of(language))
            if (!failure)
                failure = write_to(platform::text_of(path / chapter_file(*book)), markdown_chapter(*book));
        if (!failure) continue;
        print_notice(*failure);
        return exit_error;
    }
    return exit_clean;
}

/// Writes over nothing but such a list.
int write_alarms(const std::string& path) {
    if (platform::kind_of(platform::path_of(path)) != platform::FileKind::missing) {
        const auto before = Source::read_file(path);
        const auto* source = std::get_if<Source>(&before);
        if (source == nullptr || source->bytes().find(alarms_mark) == std::string_view::npos) {
            print_notice({NoticeKind::unreadable, path,
                          "this is no list that --write-alarms wrote. Name another file."});
            return exit_error;
        }
    }
    const auto failure = write_to(path, markdown_alarms());
    if (!failure) return exit_clean;
    print_notice(*failure);
    return exit_error;
}

int write_docs(const std::string& folder) {
    const fs::path path = platform::path_of(folder);
    if (!take_folder(path, generated_mark, "--write-docs")) return exit_error;
    remove_old_pages(path);
    auto failure = write_to(platform::text_of(path / index_name), markdown_index());
    for (const Rule* rule : all_rules())
        if (!failure) failure = write_to(platform::text_of(path / page_name(*rule)), written_page(*rule));
    if (!failure) return exit_clean;
    print_notice(*failure);
    return exit_error;
}

} // namespace

int run_rules_command(const RulesRequest& request) {
    const bool writes =
        !request.codes_folder.empty() || !request.docs_folder.empty() || !request.alarms_file.empty();
    int status = exit_clean;
    if (!request.codes_folder.empty()) status = write_codes(request.codes_folder);
    if (status == exit_clean && !request.docs_folder.empty()) status = write_docs(request.docs_folder);
    if (status == exit_clean && !request.alarms_file.empty()) status = write_alarms(request.alarms_file);
    if (writes) return status;
    switch (request.format) {
    case ListFormat::text: return print_text(text_list());
    case ListFormat::json: return print_text(json_rules());
    case ListFormat::markdown: return print_text(markdown_index());
    }
    return exit_error;
}

} // namespace maclint::cli
