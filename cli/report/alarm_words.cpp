//! Words for the classes of alarms.
#include "cli/report/alarm_words.hpp"

namespace maclint::cli {

std::string subject_words(const ControlAlarm& alarm) {
    const std::string_view machine = !alarm.machine                    ? ""
                                     : *alarm.machine == Machine::mill ? " of mills"
                                                                       : " of lathes";
    switch (alarm.subject) {
    case AlarmSubject::program: return "programs" + std::string(machine);
    case AlarmSubject::real_time_macro: return "real-time macros" + std::string(machine);
    case AlarmSubject::data_file: return "files of data" + std::string(machine);
    case AlarmSubject::operation: return "what the operator does" + std::string(machine);
    case AlarmSubject::machine: return "the machine" + std::string(machine);
    }
    return {};
}

std::string shown_words(const ControlAlarm& alarm) {
    const std::string text =
        alarm.subject == AlarmSubject::data_file ? "the text of the file" : "the text of the program";
    switch (alarm.shown) {
    case ShownByText::always: return text + ", always";
    case ShownByText::sometimes: return text + ", in some cases";
    case ShownByText::never: return "no text";
    }
    return {};
}

std::string_view backing_words(AlarmBacking backing) {
    switch (backing) {
    case AlarmBacking::document: return "a document has both";
    case AlarmBacking::partly: return "documents have a part";
    case AlarmBacking::memory: return "no document at hand has them";
    }
    return {};
}

std::string_view nothing_finds_it(ShownByText shown) {
    return shown == ShownByText::never ? "none: no text shows it" : "none";
}

std::vector<std::string> sources_of(const ControlAlarm& alarm) {
    std::vector<std::string> sources;
    std::string_view rest = alarm.source;
    while (!rest.empty()) {
        const auto end = std::min(rest.find("; "), rest.size());
        sources.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 2, rest.size()));
    }
    return sources;
}

} // namespace maclint::cli
