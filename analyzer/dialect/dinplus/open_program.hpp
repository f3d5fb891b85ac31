//! A program that is being read, and what its blocks so far tell about the next one.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/names.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::dinplus {

/// What the codes of a section are: commands, or elements of a contour.
enum class Context : std::uint8_t { machining, contour };

struct OpenProgram {
    ProgramBuilder builder;

    // Of the section in which the next block stands; set where the section begins.
    Context context = Context::machining;
    bool effects = true;   ///< it does something: it is no list for the operator
    bool declares = false; ///< it is VAR or CONST

    // Of the blocks before; set by the lowering.
    VariablesByName aliases = {}; ///< VAR: `#_depth=#l1`
    /// Those of the main program that its local subprograms know, too; nullptr: none. They share them.
    std::shared_ptr<const VariablesByName> inherited = {};
    std::vector<ExpressionId> selections = {}; ///< values of the open SWITCHes
    std::optional<Span> waiting_if = {};       ///< an IF whose THEN has not come

    /// The variable that the name stands for; nullptr where nothing has declared it.
    [[nodiscard]] const Variable* alias_of(std::string_view name) const;
};

} // namespace maclint::dinplus
