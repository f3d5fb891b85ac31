//! A program that is being read, and what its blocks so far tell about the next one.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/names.hpp"
#include "analyzer/source/span.hpp"
#include "analyzer/source/text_hash.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint::sinumerik {

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

/// The places of a name.
struct Uses {
    Span first;
    std::size_t count = 0;
    bool is_read = false; ///< what is only written to may be an axis, whose name the machine's maker gives
};

/// REPEAT, REPEATB or CALL BLOCK with labels.
struct Repetition {
    ItemId block;
    Span here;
    std::string first, last; ///< labels in capitals; without the last it ends in front of REPEAT
    std::vector<Label> labels;
    bool is_one_block;
    bool names_numbers; ///< of blocks
    std::optional<ExpressionId> passes;
};

struct OpenProgram {
    ProgramBuilder builder;

    // Of the blocks before; set by the lowering. Names are in capitals.
    VariablesByName variables = {}; ///< that DEF and PROC declare, arrays left out
    Arrays arrays = {};
    /// How many characters the variables of texts hold.
    std::unordered_map<std::string, std::size_t, TextHash, std::equal_to<>> text_lengths = {};
    TextSet macros = {}; ///< that DEFINE declares: each stands for any piece of a block
    /// What these stand for.
    std::unordered_map<std::string, GivenWord, TextHash, std::equal_to<>> words = {};
    /// The counters of the open FORs; nothing where the loop counts in no single variable.
    std::vector<std::optional<Variable>> counters = {};
    /// What PROC … SAVE keeps for the caller: groups, and where their codes are kept.
    std::vector<std::pair<GroupId, Variable>> saved = {};
    bool is_for_all = false;              ///< what it defines all programs may use
    bool has_file_name = false;           ///< its name is that of a file as the control has them
    Span first_code = {};                 ///< the first block that does something; empty: none so far
    std::optional<NamedPlace> frame = {}; ///< that the block before has written, with which nothing moved
    bool incremental = false; ///< G91 is in force for sure: it stands before, and nothing between leads
                              ///< elsewhere
    std::map<double, Span> actions = {};      ///< synchronised ones that surely run, by number
    std::map<double, Span> actions_left = {}; ///< those that no CANCEL has ended so far
    std::vector<Span> left_at_return = {};    ///< of these, those that ran at the last return
    std::vector<NamedPlace> labels = {};
    std::vector<NamedPlace> both_ways = {}; ///< jumps that look in both directions
    std::unordered_map<std::string, Uses, TextHash, std::equal_to<>> unknown = {}; ///< names that the program
                                                                                   ///< does not define
    TextSet unread = {};                   ///< names in blocks that cannot be read: they may define them
    std::vector<NamedPlace> repeated = {}; ///< parts of the program that REPEAT names
    std::vector<Repetition> repetitions = {};
    bool writes_frames = false; ///< some block so far has
    bool transforms = false;    ///< likewise
    /// From G291 to G290 the blocks are of another language [T].
    bool foreign_language = false;
};

} // namespace maclint::sinumerik
