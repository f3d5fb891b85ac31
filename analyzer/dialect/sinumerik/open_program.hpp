//! A program that is being read, and what its blocks so far tell about the next one.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/names.hpp"
#include "analyzer/source/span.hpp"
#include "analyzer/source/text_hash.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace maclint::sinumerik {

using NameSet = std::unordered_set<std::string, TextHash, std::equal_to<>>;

/// What DEF or PROC says of an array.
struct Array {
    std::vector<std::optional<std::int32_t>> sizes; ///< of each dimension; nothing: calculated, or as passed
    std::string_view type;                          ///< "REAL"
    Span declared;
};
using Arrays = std::unordered_map<std::string, Array, TextHash, std::equal_to<>>;

/// A label, and a word that looks for one.
struct NamedPlace {
    std::string name; ///< capitals
    Span span;
};

struct OpenProgram {
    ProgramBuilder builder;

    // Of the blocks before; set by the lowering. Names are in capitals.
    VariablesByName variables = {}; ///< that DEF and PROC declare, arrays left out
    Arrays arrays = {};
    NameSet macros = {}; ///< that DEFINE declares: each stands for any piece of a block
    /// The counters of the open FORs; nothing where the loop counts in no single variable.
    std::vector<std::optional<Variable>> counters = {};
    /// What PROC … SAVE keeps for the caller: groups, and where their codes are kept.
    std::vector<std::pair<GroupId, Variable>> saved = {};
    bool has_file_name = false;           ///< its name is that of a file as the control has them
    Span first_code = {};                 ///< the first block that does something; empty: none so far
    std::optional<NamedPlace> frame = {}; ///< that the block before has written, with which nothing moved
    bool incremental = false; ///< G91 is in force for sure: it stands before, and nothing between leads
                              ///< elsewhere
    std::vector<NamedPlace> labels = {};
    std::vector<NamedPlace> both_ways = {}; ///< jumps that look in both directions
    std::vector<NamedPlace> unknown = {};   ///< names that the program does not define
    std::vector<NamedPlace> repeated = {};  ///< parts of the program that REPEAT names
    /// From G291 to G290 the blocks are of another language [T].
    bool foreign_language = false;
};

} // namespace maclint::sinumerik
