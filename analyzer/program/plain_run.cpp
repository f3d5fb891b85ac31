//! What a run leaves set.
#include "analyzer/program/plain_run.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace maclint {

std::vector<ModalSetting> PlainRunTotals::net() const {
    std::vector<ModalSetting> settings;
    settings.reserve(static_cast<std::size_t>(std::popcount(touched_)));
    for (std::uint64_t left = touched_; left != 0; left &= left - 1) {
        const int group = std::countr_zero(left);
        settings.push_back({static_cast<GroupId>(group), last_[static_cast<std::size_t>(group)].value});
    }
    std::ranges::sort(settings, {}, [&](const ModalSetting& setting) { return last_[setting.group].at; });
    return settings;
}

} // namespace maclint
