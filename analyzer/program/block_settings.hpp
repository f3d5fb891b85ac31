//! The modal groups that a block sets by its own words, whatever lane it came through.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstddef>
#include <iterator>
#include <optional>
#include <span>

namespace maclint {

/// What a word of a block does to a modal group.
struct BlockSetting {
    GroupId group;
    std::optional<double> value; ///< nothing: it is computed
};

/// What the effect sets by itself: a word, or a call that lasts (G66). Nothing where it sets no group, or
/// where its value decides which (G#3).
[[nodiscard]] std::optional<BlockSetting> setting_of(const Program& program, const Effect& effect);

/// The settings of a block in the order of its words; those under a condition are left out. No memory of its
/// own: what it goes over must outlive it.
class BlockSettings {
  public:
    class Iterator {
      public:
        // NOLINTBEGIN(readability-identifier-naming): the standard's names for what an iterator has
        using value_type = BlockSetting;
        using difference_type = std::ptrdiff_t;
        // NOLINTEND(readability-identifier-naming)

        Iterator() = default;
        explicit Iterator(const ModalSetting* plain)
            : plain_(plain) {}
        Iterator(const Program& program, const Effect* effect, const Effect* end)
            : program_(&program)
            , effect_(effect)
            , end_(end) {
            find();
        }

        BlockSetting operator*() const {
            return plain_ == nullptr ? *found_ : BlockSetting{plain_->group, plain_->value};
        }
        Iterator& operator++() {
            if (plain_ != nullptr) {
                ++plain_;
            } else {
                ++effect_;
                find();
            }
            return *this;
        }
        Iterator operator++(int) {
            const Iterator before = *this;
            ++*this;
            return before;
        }
        friend bool operator==(const Iterator& a, const Iterator& b) {
            return a.plain_ == b.plain_ && a.effect_ == b.effect_;
        }

      private:
        void find() {
            for (; effect_ != end_; ++effect_) {
                found_ = setting_of(*program_, *effect_);
                if (found_) return;
            }
        }

        const ModalSetting* plain_ = nullptr;
        const Program* program_ = nullptr;
        const Effect* effect_ = nullptr;
        const Effect* end_ = nullptr;
        std::optional<BlockSetting> found_;
    };

    BlockSettings() = default;
    explicit BlockSettings(std::span<const ModalSetting> plain)
        : plain_(plain) {}
    BlockSettings(const Program& program, std::span<const Effect> effects)
        : program_(&program)
        , effects_(effects) {}

    [[nodiscard]] Iterator begin() const {
        return program_ == nullptr ? Iterator(plain_.data())
                                   : Iterator(*program_, effects_.data(), effects_.data() + effects_.size());
    }
    [[nodiscard]] Iterator end() const {
        const Effect* const last = effects_.data() + effects_.size();
        return program_ == nullptr ? Iterator(plain_.data() + plain_.size())
                                   : Iterator(*program_, last, last);
    }
    [[nodiscard]] bool empty() const { return begin() == end(); }

  private:
    std::span<const ModalSetting> plain_;
    const Program* program_ = nullptr; ///< of a block with effects
    std::span<const Effect> effects_;
};

} // namespace maclint
