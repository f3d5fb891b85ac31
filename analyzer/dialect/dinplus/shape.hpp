//! The shape of a block: what its parse tree depends on.
#pragma once

#include <string>
#include <string_view>

namespace maclint::dinplus {

/// Makes equal what the grammar does not look at: digits, the inside of comments and of texts. The length
/// stays.
void shape_of(std::string_view block, std::string& shape);

} // namespace maclint::dinplus
