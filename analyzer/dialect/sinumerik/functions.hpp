//! The functions whose arguments are known: what they compute, how many arguments they take, what they give.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/program/variable.hpp"

#include <cstddef>
#include <string_view>

namespace maclint::sinumerik {

struct FunctionRow {
    std::string_view name; ///< capitals
    Operation operation;   ///< `unknown` for what has no model
    std::size_t least, most;
    VariableType gives;
};

/// Nothing for a function of which the count of arguments is not certain; words.hpp knows more names.
[[nodiscard]] const FunctionRow* find_function(std::string_view capitals);

} // namespace maclint::sinumerik
