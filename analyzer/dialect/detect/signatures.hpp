//! What gives a language away: its signatures, and how many of them a text holds.
#pragma once

#include "analyzer/dialect/detect/line.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::detect {

/// Of two languages with the same evidence the first is named.
enum class Language : std::uint8_t {
    fanuc,
    din_plus,
    klartext,
    heidenhain_iso,
    sinumerik,
    linuxcnc,
    printer,
    grbl,
    wire_erosion,
    okuma,
    lnc,
    syntec,
    fagor,
    fadal,
    denford,
    traub,
    several_paths, ///< Citizen and others
    sinumerik_iso, ///< switched to the G codes of Fanuc
    acramatic,
    mazatrol,
    hobby, ///< G-code with remarks after `;`, whoever reads it
};
constexpr std::size_t language_count = 21;

/// "HEIDENHAIN Klartext"
[[nodiscard]] std::string_view name_of(Language language);

/// A language is told from four points on: one signature that nobody else writes, or several that others
/// seldom do. What is written once may be a slip or a quotation.
constexpr int enough = 4;

/// The evidence of a text.
class Evidence {
  public:
    /// `extension` in small letters, without its point.
    explicit Evidence(std::string_view extension);
    void add(const Line& line, std::size_t number);

    [[nodiscard]] int points(Language language) const;
    /// The language with most points, if they are enough and more than Fanuc has; else Fanuc.
    [[nodiscard]] Language verdict() const;
    /// The weightiest signature of the language and where it stands: "an o-word on line 3", "extension .mpf".
    [[nodiscard]] std::string reason(Language language) const;
    /// A signature that was seen, and where first.
    struct Seen {
        std::string called; ///< "'R_SKIP['", "an o-word"
        std::uint32_t line;
    };
    /// The different signatures of the language in code, in the order of the table.
    [[nodiscard]] std::vector<Seen> seen_in_code(Language language) const;

  private:
    [[nodiscard]] std::array<int, language_count> points() const;

    static constexpr std::size_t most_signatures = 224;
    struct Sighting {
        std::uint8_t times = 0;
        std::uint32_t line = 0; ///< of the first
    };

    std::string_view extension_;
    std::array<Sighting, most_signatures> sightings_{};
};

} // namespace maclint::detect
