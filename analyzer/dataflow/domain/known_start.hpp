//! Programs that are begun with what one call passes.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace maclint::dataflow {

/// With what one call begins the program that it means.
struct KnownStart {
    std::vector<KnownVariable> known;
    /// What it passes; absent: the program has no local variables of its own, or it is unknown.
    std::optional<std::vector<std::pair<Variable, Vacancy>>> arguments;
    friend bool operator==(const KnownStart&, const KnownStart&) = default;
};

struct FollowedCall {
    KnownStart start;
    bool comes_back;
};

/// The starts of one program that somebody asked about: calls of many programs begin it alike. May be asked
/// on several threads.
class KnownStarts {
  public:
    /// Whether the program comes back, which `find` finds out where nobody has asked before.
    template<class Find>
    [[nodiscard]] bool comes_back(const KnownStart& start, const Find& find) {
        const std::scoped_lock lock(mutex_);
        const auto known = std::ranges::find(all_, start, &FollowedCall::start);
        if (known != all_.end()) return known->comes_back;
        const bool comes_back = find();
        if (all_.size() < most_kept) all_.push_back({start, comes_back});
        return comes_back;
    }

  private:
    static constexpr std::size_t most_kept = 64;

    std::mutex mutex_;
    std::vector<FollowedCall> all_;
};

} // namespace maclint::dataflow
