//! Of the remarks only those on conditions need the text of their place: the others say what they are about.
#include "cli/report/remark.hpp"

#include "rules/path.hpp"

#include <string_view>

namespace maclint::cli {
namespace {

/// "true", or "false: jumps to line 7".
bool tells_of_condition(std::string_view text) {
    const std::string_view first = text.substr(0, text.find(':'));
    return first == "true" || first == "false";
}

} // namespace

std::string remark_of(const RelatedLocation& related, Remarks remarks) {
    if (remarks == Remarks::beside_code || !tells_of_condition(related.text)) return related.text;
    return "'" + quoted(related.source->bytes(related.span)) + "' is " + related.text;
}

} // namespace maclint::cli
