//! JSON; who sees a merge's marks, another tool's report or a newer version in it is told so.
#include "cli/gate/baseline_file.hpp"

#include "analyzer/source/encoding.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/source.hpp"
#include "cli/config/json_tree.hpp"
#include "cli/input/size_limits.hpp"
#include "cli/text/letters.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view version_key = "maclint-baseline";
constexpr int version = 1;

Notice refusal(const std::string& path, const std::string& what) {
    return {NoticeKind::configuration, path, what};
}

/// Thrown while a tree is read, caught in read_baseline.
struct Rejected {
    Notice notice;
};

const JsonNode* member(const JsonNode::Object& object, std::string_view key) {
    const auto found = std::ranges::find(object, key, &JsonMember::key);
    return found == object.end() ? nullptr : &found->node;
}

/// The members of the whole, or nullptr when it is no object.
const JsonNode::Object* object_of(const JsonNode* node) {
    return node == nullptr ? nullptr : std::get_if<JsonNode::Object>(&node->value);
}

std::string what_else(const JsonNode::Object* root) {
    if (root == nullptr) return "this is no baseline of maclint";
    if (member(*root, "runs") != nullptr) return "this is a SARIF report, not a baseline of maclint";
    if (member(*root, "tool") != nullptr) return "this is a JSON report, not a baseline of maclint";
    return "this is JSON, but no baseline of maclint";
}

class Reader {
  public:
    explicit Reader(const Source& source)
        : source_(source) {}

    Baseline read() {
        const auto parsed = parse_json(source_.bytes());
        if (const auto* error = std::get_if<JsonError>(&parsed))
            reject({error->at, error->at}, error->message);
        const auto* root = object_of(&std::get<JsonNode>(parsed));
        const JsonNode* number = root == nullptr ? nullptr : member(*root, version_key);
        if (number == nullptr)
            throw Rejected{refusal(source_.path(), what_else(root) + ". Name the file that '--write-baseline "
                                                                     "FILE' wrote.")};
        check_version(*number);
        const JsonNode* list = member(*root, "findings");
        const auto* entries = list == nullptr ? nullptr : std::get_if<JsonNode::Array>(&list->value);
        if (entries == nullptr) reject(number->span, "it has no list 'findings'");
        Baseline baseline;
        baseline.reserve(entries->size());
        for (const JsonNode& entry : *entries) baseline.push_back(entry_of(entry));
        return merged(std::move(baseline));
    }

  private:
    static Baseline merged(Baseline baseline) {
        std::ranges::stable_sort(baseline, {}, &BaselineEntry::place);
        Baseline merged;
        for (BaselineEntry& entry : baseline) {
            if (!merged.empty() && merged.back().place == entry.place)
                merged.back().count += entry.count;
            else
                merged.push_back(std::move(entry));
        }
        return merged;
    }

    void check_version(const JsonNode& node) const {
        const auto* number = std::get_if<double>(&node.value);
        if (number == nullptr || *number < 1 || *number != std::floor(*number))
            reject(node.span, "'" + std::string(version_key) + "' must be a whole number");
        if (*number > version)
            throw Rejected{
                refusal(source_.path(), "a newer maclint wrote this baseline (version " +
                                            std::to_string(static_cast<long long>(std::min(*number, 1e9))) +
                                            "; this one reads " + std::to_string(version) +
                                            "). Update maclint, or remove the file and write it anew "
                                            "with '--write-baseline FILE'.")};
    }

    [[nodiscard]] BaselineEntry entry_of(const JsonNode& node) const {
        const auto* members = object_of(&node);
        if (members == nullptr) reject(node.span, "an entry of 'findings' must be an object");
        BaselineEntry entry{.place = {text(*members, node, "file"), text(*members, node, "rule"),
                                      text(*members, node, "fingerprint")},
                            .block = {}};
        if (const JsonNode* count = member(*members, "count")) {
            const auto* number = std::get_if<double>(&count->value);
            if (number == nullptr || *number < 1 || *number > 1e9 || *number != std::floor(*number))
                reject(count->span, "'count' must be a whole number from 1 on");
            entry.count = static_cast<std::size_t>(*number);
        }
        if (member(*members, "block") != nullptr) entry.block = text(*members, node, "block");
        return entry;
    }

    [[nodiscard]] std::string text(const JsonNode::Object& members, const JsonNode& entry,
                                   std::string_view key) const {
        const JsonNode* node = member(members, key);
        const auto* value = node == nullptr ? nullptr : std::get_if<std::string>(&node->value);
        if (value == nullptr)
            reject(node == nullptr ? entry.span : node->span,
                   "an entry of 'findings' needs '" + std::string(key) + "', a text");
        return *value;
    }

    [[noreturn]] void reject(Span span, const std::string& what) const {
        const Position at = source_.position(span.begin);
        throw Rejected{refusal(source_.path(), "line " + std::to_string(at.line) + ", column " +
                                                   std::to_string(at.column) + ": " + what +
                                                   ". Mend it, for instance what a merge left there, or "
                                                   "remove the file and write it anew with "
                                                   "'--write-baseline FILE'.")};
    }

    const Source& source_;
};

nlohmann::ordered_json json_of(const BaselineEntry& entry) {
    nlohmann::ordered_json json = {
        {"file", entry.place.file}, {"rule", entry.place.rule}, {"fingerprint", entry.place.fingerprint}};
    if (entry.count > 1) json["count"] = entry.count;
    if (!entry.block.empty()) json["block"] = entry.block;
    return json;
}

/// The path of a file after all links of its folders. One that is a link itself keeps its name: so it is
/// known to those who have the folder. Where case does not count, the name is the one that is there.
fs::path located(const std::string& path) {
    std::error_code none;
    const fs::path absolute = fs::absolute(platform::path_of(path), none).lexically_normal();
    const auto last_name = [](const fs::path& of) { return in_lower_case(platform::text_of(of.filename())); };
    const fs::path folder = platform::place_of(absolute.parent_path());
    fs::path real = platform::place_of(absolute);
    const bool is_link = real.parent_path() != folder || last_name(real) != last_name(absolute);
    return is_link ? folder / absolute.filename() : std::move(real);
}

bool is_hexadecimal(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F'); }

} // namespace

std::variant<Baseline, Notice> read_baseline(const std::string& path, NamedBy named_by) {
    if (platform::kind_of(platform::path_of(path)) == platform::FileKind::missing)
        return refusal(path, "there is no such baseline. Write it with '--write-baseline " + shown(path) +
                                 "', or leave the name out.");
    const auto result = named_by == NamedBy::command_line ? read_file(path, baseline_limit)
                                                          : read_regular_file(path, baseline_limit);
    if (const auto* error = std::get_if<InputError>(&result)) return refusal(path, error->message);
    try {
        return Reader(std::get<Source>(result)).read();
    } catch (const Rejected& rejected) {
        return rejected.notice;
    }
}

std::string baseline_text(Baseline baseline) {
    std::ranges::sort(baseline, {}, &BaselineEntry::place);
    std::string out =
        "{\n  \"" + std::string(version_key) + "\": " + std::to_string(version) + ",\n  \"findings\": [";
    std::string_view before = "\n    ";
    for (const BaselineEntry& entry : baseline) {
        using Handler = nlohmann::ordered_json::error_handler_t;
        out.append(before).append(json_of(entry).dump(-1, ' ', false, Handler::replace));
        before = ",\n    ";
    }
    return printable_json(out + (baseline.empty() ? "]\n}\n" : "\n  ]\n}\n"));
}

bool holds_baseline(const std::string& path) {
    constexpr std::size_t head = 64;
    return beginning_of_file(path, head).find('"' + std::string(version_key) + '"') != std::string::npos;
}

std::string name_in_baseline(const std::string& path, const std::string& folder) {
    const fs::path file = located(path);
    const fs::path relative = file.lexically_relative(platform::path_of(folder));
    const std::string name = platform::text_of(relative.empty() ? file : relative);
    const bool valid = detect_encoding(name) == Encoding::utf8;
    std::string out;
    for (const char c : name) {
        constexpr std::string_view digits = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(c);
        if (c == '%' || (!valid && byte >= 0x80))
            out.append({'%', digits[byte >> 4U], digits[byte & 0xFU]});
        else
            out += c;
    }
    return out;
}

std::string path_of_name(std::string_view name, const std::string& folder) {
    std::string bytes;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::string_view code = name.substr(i, 3);
        if (code.size() == 3 && code.front() == '%' && is_hexadecimal(code[1]) && is_hexadecimal(code[2])) {
            bytes += static_cast<char>(std::stoi(std::string(code.substr(1)), nullptr, 16));
            i += 2;
        } else {
            bytes += name[i];
        }
    }
    return platform::text_of((platform::path_of(folder) / platform::path_of(bytes)).lexically_normal());
}

std::string folder_of_baseline(const std::string& path) {
    return platform::text_of(located(path).parent_path());
}

} // namespace maclint::cli
