//! A program that is being read, and what its blocks so far tell about the next one.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/names.hpp"
#include "analyzer/source/span.hpp"
#include "analyzer/source/text_hash.hpp"

#include <functional>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace maclint::sinumerik {

using NameSet = std::unordered_set<std::string, TextHash, std::equal_to<>>;

struct OpenProgram {
    ProgramBuilder builder;

    // Of the blocks before; set by the lowering. Names are in capitals.
    VariablesByName variables = {}; ///< that DEF and PROC declare, arrays left out
    NameSet arrays = {};
    NameSet macros = {}; ///< that DEFINE declares: each stands for any piece of a block
    /// The counters of the open FORs; nothing where the loop counts in no single variable.
    std::vector<std::optional<Variable>> counters = {};
    /// What PROC … SAVE keeps for the caller: groups, and where their codes are kept.
    std::vector<std::pair<GroupId, Variable>> saved = {};
    /// From G291 to G290 the blocks are of another language [T].
    bool foreign_language = false;
};

} // namespace maclint::sinumerik
