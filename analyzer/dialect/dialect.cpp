//! The registry of dialects and controls.
#include "analyzer/dialect/dialect.hpp"

#include "analyzer/dialect/dinplus/language_words.hpp"
#include "analyzer/dialect/dinplus/read.hpp"
#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/dialect/fanuc/language_words.hpp"
#include "analyzer/dialect/fanuc/read.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/sinumerik/language_words.hpp"
#include "analyzer/dialect/sinumerik/read.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"

#include <algorithm>
#include <array>

namespace maclint {
namespace {

// clang-format off
constexpr std::array<Dialect, 4> all_dialects{{
    // name    description                                     control   comments  reader, words
    {"fanuc",  "FANUC Custom Macro B and look-alikes",         "fanuc",  "(", ")", fanuc::read, fanuc::language_words},
    {"nct",    "NCT 100 series, a FANUC look-alike",           "nct",    "(", ")", fanuc::read, fanuc::language_words},
    {"dinplus","HEIDENHAIN DIN PLUS",                          "dinplus","[", "]", dinplus::read, dinplus::language_words},
    {"sinumerik","SIEMENS SINUMERIK 840D sl, 828D, 808D, ONE", "sinumerik", ";", "", sinumerik::read, sinumerik::language_words},
}};
// clang-format on

std::vector<const ControlModel*> collect_controls() {
    std::vector<const ControlModel*> controls;
    for (const ControlModel& control : fanuc::fanuc_controls()) controls.push_back(&control);
    controls.push_back(&dinplus::control());
    for (const ControlModel& control : sinumerik::controls()) controls.push_back(&control);
    return controls;
}

} // namespace

std::span<const Dialect> dialects() { return all_dialects; }

const Dialect* find_dialect(std::string_view name) {
    const auto* dialect = std::ranges::find(all_dialects, name, &Dialect::name);
    return dialect == all_dialects.end() ? nullptr : dialect;
}

std::span<const ControlModel* const> controls() {
    static const std::vector<const ControlModel*> all = collect_controls();
    return all;
}

const ControlModel* find_control(std::string_view name) {
    for (const ControlModel* control : controls())
        if (control->name == name) return control;
    return nullptr;
}

} // namespace maclint
