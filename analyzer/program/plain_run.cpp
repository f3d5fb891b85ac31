//! What a run leaves set.
#include "analyzer/program/plain_run.hpp"

#include <algorithm>

namespace maclint {

std::vector<ModalSetting> PlainRunTotals::net() const {
    std::vector<ModalSetting> settings;
    settings.reserve(touched_.size());
    touched_.for_each([&](GroupId group) { settings.push_back({group, last_[group].value}); });
    std::ranges::sort(settings, {}, [&](const ModalSetting& setting) { return last_[setting.group].at; });
    return settings;
}

} // namespace maclint
