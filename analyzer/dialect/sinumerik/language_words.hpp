//! What the words of SINUMERIK programs mean, for people.
#pragma once

#include "analyzer/program/language_words.hpp"

namespace maclint::sinumerik {

[[nodiscard]] LanguageTables language_words();

} // namespace maclint::sinumerik
