//! What the words of Custom Macro B mean, for people.
#pragma once

#include "analyzer/program/language_words.hpp"

namespace maclint::fanuc {

[[nodiscard]] LanguageTables language_words();

} // namespace maclint::fanuc
