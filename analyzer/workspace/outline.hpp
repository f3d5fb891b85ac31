//! What has to be known of a program to tell which others it belongs with: its names and its calls.
#pragma once

#include "analyzer/program/call_kinds.hpp"
#include "analyzer/program/model.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace maclint {

/// Only the running program knows which program it calls.
struct ComputedName {
    friend bool operator==(ComputedName, ComputedName) = default;
};

struct CallOutline {
    /// The number or name in capitals; monostate: the text does not say.
    std::variant<std::monostate, ComputedName, std::int64_t, std::string> program;
    LookupScope lookup = LookupScope::everywhere;

    [[nodiscard]] bool is_computed() const { return std::holds_alternative<ComputedName>(program); }
    friend bool operator==(const CallOutline&, const CallOutline&) = default;
};

struct ProgramOutline {
    std::string_view language; ///< of the control, which has to outlive the outline
    std::optional<std::int64_t> number;
    std::vector<std::string> names; ///< in capitals, sorted, each once
    std::string folder = {};        ///< on the control, in capitals, where the text says it
    bool local = false;             ///< only programs of its own file can call it
    bool started_by_hand = false;
    std::vector<std::string> given_names = {}; ///< that it defines for all programs; in capitals
    std::vector<GivenWord> given_words = {};   ///< of these, those that stand for pieces of blocks
    std::vector<ArrayDefinition> arrays = {};  ///< of these, where it gives names
    std::vector<CallOutline> calls;            ///< in the order of for_each_effect
    friend bool operator==(const ProgramOutline&, const ProgramOutline&) = default;
};

/// Of all programs of a file. Copies share them: a folder has thousands, of which an edit changes one.
class ProgramOutlines {
  public:
    ProgramOutlines() = default;
    explicit ProgramOutlines(std::vector<ProgramOutline> programs)
        : shared_(std::make_shared<const std::vector<ProgramOutline>>(std::move(programs))) {}

    [[nodiscard]] auto begin() const { return all().begin(); }
    [[nodiscard]] auto end() const { return all().end(); }
    [[nodiscard]] std::size_t size() const { return all().size(); }
    [[nodiscard]] const ProgramOutline& operator[](std::size_t place) const { return (*shared_)[place]; }
    friend bool operator==(const ProgramOutlines& one, const ProgramOutlines& other) {
        return one.shared_ == other.shared_ || std::ranges::equal(one, other);
    }

  private:
    [[nodiscard]] std::span<const ProgramOutline> all() const {
        return shared_ == nullptr ? std::span<const ProgramOutline>() : *shared_;
    }

    std::shared_ptr<const std::vector<ProgramOutline>> shared_;
};

struct FileOutline {
    std::string path;
    ProgramOutlines programs;
    char code_system = 0; ///< of the control that it is read for; 0: its codes come in none
    MachineSigns machine_signs = {};
    friend bool operator==(const FileOutline&, const FileOutline&) = default;
};

/// Of a file that was read whole, or only its names and calls.
[[nodiscard]] FileOutline outline_of(const ProgramFile& file);

} // namespace maclint
