//! Sets of files, joined call by call.
#include "analyzer/workspace/groups.hpp"

#include "analyzer/workspace/calls_of_files.hpp"

#include <numeric>
#include <unordered_map>

namespace maclint {
namespace {

/// Disjoint sets; the one with the lowest number stands for its set.
class Sets {
  public:
    explicit Sets(std::size_t count)
        : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    std::size_t find(std::size_t member) {
        while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
        return member;
    }

    void join(std::size_t one, std::size_t other) {
        one = find(one);
        other = find(other);
        parent_[std::max(one, other)] = std::min(one, other);
    }

  private:
    std::vector<std::size_t> parent_;
};

} // namespace

std::vector<std::vector<std::size_t>> groups_of(std::span<const FileOutline> files) {
    const std::vector<std::size_t> file_of = files_of_programs(files);
    const CallResolver resolver(files);
    Sets sets(files.size());
    std::unordered_map<const NamesakeList*, std::size_t>
        joined; ///< lists, each with a file that it belongs to
    for_each_called_list(resolver, files, [&](std::size_t file, const NamesakeList& namesakes) {
        const auto [before, fresh] = joined.try_emplace(&namesakes, file);
        sets.join(file, before->second);
        if (!fresh) return;
        for (const ProgramIndex meant : namesakes) sets.join(file, file_of[meant]);
    });
    std::vector<std::vector<std::size_t>> by_first(files.size());
    for (std::size_t file = 0; file < files.size(); ++file) by_first[sets.find(file)].push_back(file);
    std::erase_if(by_first, [](const auto& group) { return group.empty(); });
    return by_first;
}

} // namespace maclint
