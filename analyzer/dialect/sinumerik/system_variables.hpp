//! The system variables: which there are, and what they hold.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace maclint::sinumerik {

enum class SystemType : std::uint8_t { integer, real, truth, character, text, axis, frame };

struct SystemVariable {
    SystemType type;
    std::uint8_t indices; ///< how many it takes
};

/// Nothing for a name of no row [SV]. Capitals, with its `$`; `$$` reads the same at another time.
[[nodiscard]] std::optional<SystemVariable> find_system_variable(std::string_view capitals);

/// What a variable holds that programs can only read: "an input"; empty where they may store something in
/// it, or where it is not known.
[[nodiscard]] std::string_view held_by_read_only(std::string_view capitals);

/// Machine, setting and compensation data and the like, which no row lists: `$MC_…`, `$SA_…` [MD].
[[nodiscard]] bool is_control_data(std::string_view capitals);

/// Whether a read waits for all blocks before it, and may differ from the read before: what the machine does
/// now, `$A…` and `$V…`. A few of them are read ahead all the same, and no row here says which [SV].
[[nodiscard]] bool is_main_run_variable(std::string_view capitals);

/// Whether it holds what programs have stored in it, and nothing else: `$AC_MARKER[1]`, `$AC_PARAM[1]`.
[[nodiscard]] bool is_kept_for_programs(std::string_view capitals);

} // namespace maclint::sinumerik
