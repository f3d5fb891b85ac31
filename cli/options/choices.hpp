//! The words of options that take one of a few.
#pragma once

#include "cli/command_line.hpp"
#include "cli/options/words.hpp"

#include <array>

namespace maclint::cli {

inline constexpr std::array<Choice<Format>, 8> formats{{{"text", Format::text},
                                                        {"concise", Format::concise},
                                                        {"json", Format::json},
                                                        {"sarif", Format::sarif},
                                                        {"github", Format::github},
                                                        {"gitlab", Format::gitlab},
                                                        {"junit", Format::junit},
                                                        {"checkstyle", Format::checkstyle}}};
inline constexpr std::array<Choice<ListFormat>, 3> list_formats{
    {{"text", ListFormat::text}, {"json", ListFormat::json}, {"markdown", ListFormat::markdown}}};
/// Of what has no page in Markdown.
inline constexpr std::array<Choice<ListFormat>, 2> plain_list_formats{
    {{"text", ListFormat::text}, {"json", ListFormat::json}}};
inline constexpr std::array<Choice<ColourChoice>, 3> colours{
    {{"auto", ColourChoice::automatic}, {"always", ColourChoice::always}, {"never", ColourChoice::never}}};
inline constexpr std::array<Choice<PathDetail>, 3> path_details{
    {{"full", PathDetail::full}, {"short", PathDetail::shortened}, {"none", PathDetail::none}}};

} // namespace maclint::cli
