//! What a run leaves set.
#include "analyzer/program/plain_run.hpp"

#include <cstddef>

namespace maclint {

std::vector<ModalSetting> PlainRunTotals::net() const {
    std::vector<ModalSetting> settings;
    for (std::size_t group = 0; group < last_.size(); ++group)
        if ((touched_ >> group & 1) != 0) settings.push_back({static_cast<GroupId>(group), last_[group]});
    return settings;
}

} // namespace maclint
