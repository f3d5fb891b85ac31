//! Line by line from the head of the text.
#include "analyzer/dialect/detect/first_program.hpp"

#include "analyzer/dialect/detect/line.hpp"
#include "analyzer/dialect/detect/shapes.hpp"

#include <algorithm>

namespace maclint::detect {
namespace {

bool ends_program(const Line& line) {
    return line.has('M', 20, 20) || line.has('M', 300, 300) || line.has('M', 990, 990);
}

} // namespace

std::string_view first_program(std::string_view text) {
    Line line;
    bool begun = false;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        line.read(text.substr(at, end - at));
        at = end + 1;
        if (line.whole().empty() || (!begun && line.whole() == "%")) continue;
        if (!(begun ? looks_like_block(line.whole()) : program_number(line))) return {};
        if (begun && ends_program(line)) return text.substr(0, end);
        begun = true;
    }
    return {};
}

} // namespace maclint::detect
