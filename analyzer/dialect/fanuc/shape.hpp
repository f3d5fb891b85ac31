//! The shape of a block: what is left of its text when everything is taken out that the grammar does not look
//! at.
#pragma once

#include <string>
#include <string_view>

namespace maclint::fanuc {

/// Writes the shape of `block` into `shape`: same length, digits and comment text made equal.
void shape_of(std::string_view block, std::string& shape);

} // namespace maclint::fanuc
