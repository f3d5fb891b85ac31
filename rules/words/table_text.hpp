//! A text of a table: half as large as a std::string_view, and rows have twenty of them.
#pragma once

#include <string>
#include <string_view>

namespace maclint {

/// Ends with a zero, and lives as long as the program does, or as the string that it was made of.
class TableText {
  public:
    constexpr TableText() = default;
    constexpr TableText(const char* text)
        : text_{text[0] == '\0' ? nullptr : text} {} // NOLINT(*-explicit-*)
    TableText(const std::string& text)
        : TableText(text.c_str()) {} // NOLINT(*-explicit-*)
    TableText(std::string&&) = delete;

    constexpr operator std::string_view() const { // NOLINT(*-explicit-*)
        return text_ == nullptr ? std::string_view{} : std::string_view{text_};
    }
    [[nodiscard]] constexpr std::string_view view() const { return *this; }
    [[nodiscard]] constexpr bool empty() const { return text_ == nullptr; }
    [[nodiscard]] friend constexpr bool operator==(TableText a, std::string_view b) { return a.view() == b; }
    [[nodiscard]] friend constexpr bool operator==(TableText a, TableText b) { return a.view() == b.view(); }
    [[nodiscard]] friend constexpr bool operator==(TableText a, const char* b) { return a.view() == b; }

  private:
    const char* text_ = nullptr;
};

} // namespace maclint
