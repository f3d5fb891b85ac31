//! Remarks that mean something: descriptions of transfer values, and what a converter could not translate.
#pragma once

#include "analyzer/program/syntax_error.hpp"
#include "analyzer/source/source.hpp"

#include <vector>

namespace maclint::dinplus {

/// Adds what is wrong with the descriptions that stand between two [//], and remarks that a converter left in
/// the place of a block.
void check_remarks(const Source& source, std::vector<SyntaxError>& syntax_errors);

} // namespace maclint::dinplus
