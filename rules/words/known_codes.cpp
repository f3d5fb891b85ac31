//! Asks the shop first, then the modal groups, then the chapters.
#include "rules/words/known_codes.hpp"

#include "analyzer/program/own_codes.hpp"
#include "rules/words/code_pages.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace maclint {
namespace {

/// Whether a chapter of the language has it, on whatever control.
bool any_control_has(const ControlModel& control, char letter, double code) {
    return has_page_anywhere(control.language, letter, code);
}

/// Whether the chapters tell the codes of this control at all: every one has a rapid move.
bool has_chapters(const ControlModel& control) {
    return control.assumed ? any_control_has(control, 'G', 0) : has_code_page(control, 'G', 0);
}

bool is_free(const ControlModel& control, char letter, double code) {
    return letter != 'G' || (control.first_free_code != 0 && code >= control.first_free_code);
}

} // namespace

CodeStanding standing_of(const ControlModel& control, char letter, double code) {
    using enum CodeStanding;
    if (const OwnCode* own = own_code(control, letter, code))
        return own->program == maclint::not_fitted ? CodeStanding::not_fitted : known;
    if (!has_chapters(control) || control.group_of(letter, code)) return known;
    if (is_free(control, letter, code)) {
        if (!are_listed(control, letter)) return known;
        return has_code_page(control, letter, code) ? known : not_listed;
    }
    if (control.assumed) return any_control_has(control, letter, code) ? known : of_no_control;
    return has_code_page(control, letter, code) ? known : unknown;
}

namespace {

/// As far as one may be unknown.
std::size_t last_of(const ControlModel& control, char letter) {
    return is_free(control, letter, CodeNumbers::capacity) && !are_listed(control, letter)
               ? static_cast<std::size_t>(letter == 'G' ? control.first_free_code : 0)
               : CodeNumbers::capacity;
}

template<class Visit>
void for_each_unknown(const ControlModel& control, const Visit& visit) {
    for (const char letter : {'G', 'M'})
        for (std::size_t code = 0; code < last_of(control, letter); ++code)
            if (standing_of(control, letter, static_cast<double>(code)) != CodeStanding::known)
                visit(letter, code);
    for (const OwnCode& own : control.own_codes)
        if (own.program == not_fitted) visit(own.letter, static_cast<std::size_t>(own.number));
}

std::vector<LetterCodes> find_codes(const ControlModel& control) {
    std::array<LetterCodes, 2> found{{{'G', {}}, {'M', {}}}};
    std::array<bool, 2> any{};
    const auto at = [](char letter) { return letter == 'G' ? 0U : 1U; };
    if (!has_chapters(control) && control.own_codes.empty()) return {};
    for_each_unknown(control, [&](char letter, std::size_t code) {
        found.at(at(letter)).codes.add(static_cast<double>(code));
        any.at(at(letter)) = true;
    });
    std::vector<LetterCodes> wanted;
    for (const char letter : {'G', 'M'}) {
        if (last_of(control, letter) == CodeNumbers::capacity) {
            found.at(at(letter)).codes.add_beyond();
            any.at(at(letter)) = true;
        }
        if (any.at(at(letter))) wanted.push_back(found.at(at(letter)));
    }
    return wanted;
}

syntax::CodeSet kinds_of_codes(const ControlModel& control) {
    syntax::CodeSet kinds;
    for_each_unknown(control, [&](char letter, std::size_t code) {
        kinds.add(syntax::CodeSet::kind_of(letter == 'G' ? 0 : 1, code));
    });
    for (const char letter : {'G', 'M'}) // those of a thousand and more may be of any kind
        if (last_of(control, letter) == CodeNumbers::capacity)
            for (std::size_t code = 0; code < syntax::CodeSet::capacity; ++code)
                kinds.add(syntax::CodeSet::kind_of(letter == 'G' ? 0 : 1, code));
    return kinds;
}

std::shared_ptr<const CodesToLookAt> find(const ControlModel& control) {
    return std::make_shared<const CodesToLookAt>(CodesToLookAt{find_codes(control), kinds_of_codes(control)});
}

} // namespace

std::shared_ptr<const CodesToLookAt> codes_to_look_at(const ControlModel& control) {
    if (!control.own_codes.empty()) return find(control);
    // Many programs are for the same few controls; one that a shop has named has the codes of its model.
    static std::mutex mutex;
    static std::map<std::pair<std::string, bool>, std::shared_ptr<const CodesToLookAt>> known;
    const std::scoped_lock lock(mutex);
    auto& found = known[{control.name, control.assumed}];
    if (found == nullptr) found = find(control);
    return found;
}

} // namespace maclint
