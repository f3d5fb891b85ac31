//! Words of axes that the machine lacks, where its configuration names those which it has.
#pragma once

#include "analyzer/program/model.hpp"

#include <functional>

namespace maclint::rules {

/// `visit(word)` for each word that moves, sets or returns such an axis. Words of calls, and of codes that
/// take the letter for something else, are none; of a lathe, whose letters mean more, only Y and V are known
/// to be.
void for_each_missing_axis(const Program& program, const std::function<void(const Word&)>& visit);

} // namespace maclint::rules
