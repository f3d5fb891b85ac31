//! Asks each block of a number whether it is a target.
#include "analyzer/queries/structure/wrong_places.hpp"

#include <utility>

namespace maclint::queries {
namespace {

std::optional<std::string> wrong_place(const ProgramFile& file, std::int64_t number,
                                       const WrongPlaces::IsTarget& is_target) {
    std::string elsewhere;
    for (const NumberedBlock& block : find_blocks(file, {number})) {
        if (is_target(block)) return std::nullopt;
        if (block.section != nullptr) elsewhere = block.section->name;
    }
    return elsewhere;
}

} // namespace

WrongPlaces::WrongPlaces(const ProgramFile& file, IsTarget is_target)
    : file_(file)
    , is_target_(std::move(is_target)) {}

const std::optional<std::string>& WrongPlaces::of(std::int64_t number) {
    const auto [at, fresh] = known_.try_emplace(number);
    if (fresh) at->second = wrong_place(file_, number, is_target_);
    return at->second;
}

} // namespace maclint::queries
