//! The functions and procedures whose arguments are known: what they compute, take and give.
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
    VariableType gives; ///< of a procedure, which gives nothing, any
    /// What the arguments are, a letter each; any where there is another or none.
    std::string_view takes;
    static constexpr char takes_number = 'n', takes_text = 't';
};

/// Nothing for a function of which the count of arguments is not certain; words.hpp knows more names.
[[nodiscard]] const FunctionRow* find_function(std::string_view capitals);

} // namespace maclint::sinumerik
