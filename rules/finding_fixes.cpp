//! Fixes of a finding, and of findings that become one.
#include "rules/finding.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace maclint {
namespace {

/// Two insertions at one place would come out in the order of whoever applies them.
bool touch(const Edit& earlier, const Edit& later) {
    return earlier.source == later.source &&
           (later.span.begin < earlier.span.end || later.span.begin == earlier.span.begin);
}

/// Whether the edit can be added after the others, which are in the order of the text.
bool comes_after(const Edit& last, const Edit& next) {
    return last.source == next.source && last.span.begin < next.span.begin && !touch(last, next);
}

/// Adds the edits of a fix for a later place. One that reaches into what is changed already is left out
/// whole: that place is mended by another run.
void append(Fix later, Fix& fix) {
    if (!comes_after(fix.edits.back(), later.edits.front())) return;
    std::ranges::move(later.edits, std::back_inserter(fix.edits));
    fix.applicability = std::max(fix.applicability, later.applicability);
}

/// "Write" of "Write 'X10.5'": what is done at each place alike.
std::string_view verb_of(std::string_view title) { return title.substr(0, title.find(' ')); }

} // namespace

std::string_view name_of(Applicability applicability) {
    return applicability == Applicability::safe ? "safe" : "unsafe";
}

void Finding::offer(Fix offered) {
    std::ranges::sort(offered.edits, {}, [](const Edit& edit) {
        return std::pair(std::string_view(edit.source->path()), edit.span.begin);
    });
    if (offered.edits.empty() || std::ranges::adjacent_find(offered.edits, touch) != offered.edits.end())
        return;
    fixes.push_back(std::move(offered));
}

void Finding::add_repeat(Finding same) {
    for (Fix& other : same.fixes) {
        const auto own = std::ranges::find_if(
            fixes, [&](const Fix& fix) { return verb_of(fix.title) == verb_of(other.title); });
        if (own != fixes.end())
            append(std::move(other), *own);
        else
            fixes.push_back(std::move(other));
    }
    repeats.push_back({std::move(same.source), same.span, "the same stands here"});
}

} // namespace maclint
