//! Letters of ASCII alone: those are what codes, names and options are made of.
#include "cli/text/letters.hpp"

#include <algorithm>
#include <cctype>

namespace maclint::cli {
namespace {

template<class Change>
std::string changed(std::string_view text, Change change) {
    std::string out(text);
    std::ranges::transform(out, out.begin(), [change](char c) {
        return static_cast<char>(change(static_cast<unsigned char>(c)));
    });
    return out;
}

} // namespace

std::string in_lower_case(std::string_view text) {
    return changed(text, [](int c) { return std::tolower(c); });
}

std::string in_upper_case(std::string_view text) {
    return changed(text, [](int c) { return std::toupper(c); });
}

} // namespace maclint::cli
