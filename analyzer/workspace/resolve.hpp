//! Finds the program that a call means: the nearest one wins, several equally near mean unknown.
#pragma once

#include "analyzer/workspace/outline.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint {

using ProgramIndex = std::uint32_t; ///< place among the programs of all files, in the order of the files

/// Programs of one number or name that are equally near to every call that may mean any of them.
using NamesakeList = std::vector<ProgramIndex>;

/// What a call may mean.
struct Namesakes {
    /// The nearest ones. Calls share the lists; more than one where lists of several places are equally near.
    std::vector<std::shared_ptr<const NamesakeList>> nearest;
    std::size_t all = 0; ///< programs of that number or name, near or far

    /// The only program that is nearest.
    [[nodiscard]] std::optional<ProgramIndex> only() const;
};

class CallResolver {
  public:
    /// The outlines have to outlive it.
    explicit CallResolver(std::span<const FileOutline> files);
    /// What a call of a program in the file may mean.
    [[nodiscard]] Namesakes resolve(std::size_t file, const ProgramOutline& caller,
                                    const CallOutline& call) const;

  private:
    /// The nearest programs, seen from somewhere.
    struct Nearest {
        std::size_t steps = static_cast<std::size_t>(-1);
        std::size_t all = 0; ///< programs looked at, near or far
        std::shared_ptr<NamesakeList> programs;

        void consider(ProgramIndex program, std::size_t steps_to_it);
    };
    struct Places {
        std::unordered_map<std::string_view, Nearest> below; ///< a folder, as seen from it; no local programs
        std::unordered_map<std::size_t, Nearest> in_file, local; ///< only the file sees local ones
    };
    struct ProgramInFile {
        std::size_t file;
        const ProgramOutline* outline;
    };
    /// All programs of a number or a name. One that is not local and has no namesakes is meant from
    /// everywhere.
    struct ProgramsByName {
        std::shared_ptr<NamesakeList> only_one;
        ProgramInFile where_it_is{};    ///< the only one
        std::unique_ptr<Places> places; ///< otherwise
    };
    /// A language, and a number or name in it.
    template<class Name>
    using Called = std::pair<std::string_view, Name>;
    struct CalledHash {
        template<class Name>
        std::size_t operator()(const Called<Name>& called) const {
            constexpr std::size_t odd = 31; // numbers in a row stay side by side
            return odd * std::hash<std::string_view>{}(called.first) + std::hash<Name>{}(called.second);
        }
    };
    template<class Name>
    using Index = std::unordered_map<Called<Name>, ProgramsByName, CalledHash>;

    void add(ProgramsByName& named, ProgramInFile program, ProgramIndex index) const;
    void add_to_places(Places& places, ProgramInFile program, ProgramIndex index) const;
    [[nodiscard]] const ProgramsByName* programs_named(const ProgramOutline& caller,
                                                       const CallOutline& call) const;

    /// The folder that the program is in.
    [[nodiscard]] std::string_view home_of(std::size_t file, const ProgramOutline& program) const;

    std::span<const FileOutline> files_;
    std::map<std::pair<std::size_t, std::string_view>, std::string>
        homes_; ///< of files that name folders of the control
    Index<std::int64_t> by_number_;
    Index<std::string_view> by_name_;
};

} // namespace maclint
