//! Tarjan's algorithm with an explicit stack: a chain of calls may be as long as the workspace.
#include "analyzer/flow/components.hpp"

#include <algorithm>

namespace maclint::flow {
namespace {

constexpr std::uint32_t unseen = 0xFFFFFFFF;

class Tarjan {
  public:
    explicit Tarjan(const Adjacency& adjacency)
        : adjacency_(adjacency)
        , index_(adjacency.size(), unseen)
        , low_(adjacency.size(), 0)
        , waiting_(adjacency.size(), false) {
        result_.of.assign(adjacency.size(), unseen);
        result_.members.reserve(adjacency.size(), adjacency.size());
        stack_.reserve(adjacency.size());
        frames_.reserve(adjacency.size());
    }

    Components run() {
        for (std::uint32_t node = 0; node < adjacency_.size(); ++node)
            if (index_[node] == unseen) visit_from(node);
        return std::move(result_);
    }

  private:
    struct Frame {
        std::uint32_t node;
        std::size_t next;
    };

    void enter(std::uint32_t node) {
        index_[node] = low_[node] = count_++;
        waiting_[node] = true;
        stack_.push_back(node);
        frames_.push_back({node, 0});
    }

    void visit_from(std::uint32_t root) {
        enter(root);
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            const std::uint32_t node = frame.node;
            if (frame.next < adjacency_[node].size()) {
                const std::uint32_t to = adjacency_[node][frame.next++];
                if (index_[to] == unseen)
                    enter(to);
                else if (waiting_[to])
                    low_[node] = std::min(low_[node], index_[to]);
                continue;
            }
            frames_.pop_back();
            if (!frames_.empty()) low_[frames_.back().node] = std::min(low_[frames_.back().node], low_[node]);
            if (low_[node] == index_[node]) close_component(node);
        }
    }

    void close_component(std::uint32_t root) {
        members_.clear();
        std::uint32_t node = unseen;
        do {
            node = stack_.back();
            stack_.pop_back();
            waiting_[node] = false;
            result_.of[node] = static_cast<std::uint32_t>(result_.members.size());
            members_.push_back(node);
        } while (node != root);
        std::ranges::sort(members_);
        for (const std::uint32_t member : members_) result_.members.add(member);
        result_.members.end_list();
    }

    const Adjacency& adjacency_;
    std::vector<std::uint32_t> index_, low_;
    std::vector<bool> waiting_;
    std::vector<std::uint32_t> stack_, members_;
    std::vector<Frame> frames_;
    std::uint32_t count_ = 0;
    Components result_;
};

} // namespace

Components find_components(const Adjacency& adjacency) { return Tarjan(adjacency).run(); }

std::vector<std::vector<std::uint32_t>> layers_of(const Adjacency& adjacency, const Components& components) {
    std::vector<std::size_t> height(components.members.size(), 0);
    std::vector<std::vector<std::uint32_t>> layers;
    for (std::uint32_t component = 0; component < components.members.size(); ++component) {
        for (const std::uint32_t node : components.members[component])
            for (const std::uint32_t to : adjacency[node])
                if (components.of[to] != component)
                    height[component] = std::max(height[component], height[components.of[to]] + 1);
        if (height[component] >= layers.size()) layers.resize(height[component] + 1);
        layers[height[component]].push_back(component);
    }
    return layers;
}

} // namespace maclint::flow
