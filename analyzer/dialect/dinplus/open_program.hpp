//! A program that is being read, and what its blocks so far tell about the next one.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/names.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
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
    std::unordered_map<Variable, std::string_view, VariableHash> first_names =
        {}; ///< in VAR, of each variable
    /// Those of the main program that its local subprograms know, too; nullptr: none. They share them.
    std::shared_ptr<const VariablesByName> inherited = {};
    /// All names that the main program declares; nullptr: it is the main program.
    std::shared_ptr<const VariablesByName> of_main = {};
    /// No caller can have declared others: it is a main program, or local to one.
    bool knows_all_names = false;
    bool declares_something_unreadable = false; ///< in VAR or CONST
    std::vector<ExpressionId> selections = {};  ///< values of the open SWITCHes
    std::vector<Span> groups = {};              ///< BLOCKSTARTs without their BLOCKEND so far
    std::optional<Span> waiting_if = {};        ///< an IF whose THEN has not come

    /// The variable that the name stands for; nullptr where nothing has declared it.
    [[nodiscard]] const Variable* alias_of(std::string_view name) const;
    [[nodiscard]] bool main_declares(std::string_view name) const {
        return of_main != nullptr && of_main->contains(name);
    }
};

} // namespace maclint::dinplus
