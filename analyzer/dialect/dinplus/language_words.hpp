//! What the words of DIN PLUS mean, for people.
#pragma once

#include "analyzer/program/language_words.hpp"

namespace maclint::dinplus {

[[nodiscard]] LanguageTables language_words();

} // namespace maclint::dinplus
