//! Digits become '0', comment text becomes '-'.
#include "analyzer/dialect/fanuc/shape.hpp"

namespace maclint::fanuc {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

} // namespace

void shape_of(std::string_view block, std::string& shape) {
    shape.assign(block);
    bool comment = false;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        if (comment) {
            comment = shape[i] != ')' && shape[i] != '\n' && shape[i] != '\r';
            if (comment) shape[i] = '-';
        } else if (shape[i] == '(') {
            comment = true;
        } else if (is_digit(shape[i]) && (i == 0 || block[i - 1] != '/')) {
            // Behind '/' the digit counts: a skip level is one of 1 to 9.
            shape[i] = '0';
        }
    }
}

} // namespace maclint::fanuc
