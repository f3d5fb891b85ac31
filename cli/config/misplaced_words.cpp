//! The keys of other linters are those that people remember.
#include "cli/config/misplaced_words.hpp"

#include "cli/config/rule_words.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli {
namespace {

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, in_lower_case(word)) != words.end();
}

std::string quotes(std::string_view word) { return "\"" + std::string(word) + "\""; }

std::string ignored(std::string_view rules) { return "\"ignore\": [ " + quotes(rules) + " ]"; }

} // namespace

std::string advice_for_key(std::string_view key) {
    if (!rules_named(key).empty())
        return "Write " + ignored(key) + " to switch it off, or \"severity\": { " + quotes(key) +
               ": \"warning\" }";
    if (is_one_of(key, {"rules", "rule", "checks", "linters"}))
        return "Rules are named in 'select', 'ignore' and 'severity', for instance " + ignored("MAC501");
    if (is_one_of(key, {"disable", "disabled", "off", "ignores", "ignorerules"}))
        return "Rules are switched off in 'ignore', for instance " + ignored("MAC501");
    if (is_one_of(key, {"control", "model", "machine"}))
        return "Controls are named in 'controls', and which files are for one in 'files', for instance "
               "\"files\": [ { \"glob\": \"**\", \"control\": \"fanuc-30i\" } ]";
    if (is_one_of(key, {"dialect", "language"}))
        return "Which files are in a language stands in 'files', for instance \"files\": [ { \"glob\": "
               "\"**\", \"dialect\": \"dinplus\" } ]";
    return "";
}

std::string advice_for_severity(std::string_view rules, std::string_view word) {
    if (is_one_of(word, {"off", "none", "ignore", "never", "disable", "disabled", "0"}))
        return ", or " + ignored(rules) + " beside 'severity' to switch it off";
    if (is_one_of(word, {"on", "default"})) return ", or leave it out where the rule is to be as it comes";
    return "";
}

} // namespace maclint::cli
