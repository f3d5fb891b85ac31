//! Reads the remarks at the head of each program, and looks for the words of several languages.
#include "analyzer/dialect/maker_rights.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace maclint {
namespace {

constexpr Offset most_looked_at = 8192; ///< bytes of a head

/// In capitals, one blank between words; what is not ASCII stands as it is.
constexpr std::array<std::string_view, 24> rights{
    "COPYRIGHT",
    "RIGHTS RESERVED",
    "ALLE RECHTE",
    "RECHTE VORBEHALTEN",
    "URHEBERRECHT",
    "TOUS DROITS",
    "DROITS RESERV",
    "DERECHOS RESERVADOS",
    "TODOS LOS DERECHOS",
    "DIREITOS RESERVADOS",
    "TODOS OS DIREITOS",
    "DIRITTI RISERVATI",
    "TUTTI I DIRITTI",
    "RECHTEN VOORBEHOUDEN",
    "WSZELKIE PRAWA",
    "PRAVA VYHRAZENA",
    "\xC2\xA9",                                                          // ©
    "\xE7\x89\x88\xE6\x9D\x83\xE6\x89\x80\xE6\x9C\x89",                  // 版权所有
    "\xE7\x89\x88\xE6\xAC\x8A\xE6\x89\x80\xE6\x9C\x89",                  // 版權所有
    "\xE8\x91\x97\xE4\xBD\x9C\xE6\xA8\xA9",                              // 著作権
    "\xE7\x84\xA1\xE6\x96\xAD\xE8\xBB\xA2\xE8\xBC\x89",                  // 無断転載
    "\xD0\x92\xD1\x81\xD0\xB5 \xD0\xBF\xD1\x80\xD0\xB0\xD0\xB2\xD0\xB0", // Все права
    "\xD0\x92\xD0\xA1\xD0\x95 \xD0\x9F\xD0\xA0\xD0\x90\xD0\x92\xD0\x90", // ВСЕ ПРАВА
    "VYHRAZENA",
};

/// Rights to what wrote the program, to a drawing or an engraving, and none at all. Words that end so count
/// as well: MASTERCAM, BOBCAD.
constexpr std::array<std::string_view, 39> others{"CAM ",
                                                  "CAD ",
                                                  " POST ",
                                                  " POSTPROCESSOR",
                                                  " POST PROCESSOR",
                                                  " PP ",
                                                  " GENERATED ",
                                                  " SOFTWARE ",
                                                  " ESPRIT ",
                                                  " HYPERMILL ",
                                                  " AUTODESK ",
                                                  " FUSION ",
                                                  " HSM",
                                                  "HSM ",
                                                  " INVENTOR ",
                                                  " POWERMILL ",
                                                  " TOPSOLID ",
                                                  " TEBIS ",
                                                  " CIMATRON ",
                                                  " WORKNC ",
                                                  " PARTMAKER ",
                                                  " SIEMENS NX ",
                                                  " UNIGRAPHICS ",
                                                  " CATIA ",
                                                  " VISI ",
                                                  " VERICUT ",
                                                  " NCSIMUL ",
                                                  " SMARTCAM",
                                                  " DELCAM",
                                                  " DRAWING ",
                                                  " ENGRAV",
                                                  " GRAVUR",
                                                  " CHECK COPYRIGHT",
                                                  " COPYRIGHT NONE ",
                                                  " NO COPYRIGHT",
                                                  " COPYRIGHT FREE ",
                                                  " PUBLIC DOMAIN ",
                                                  " OHNE COPYRIGHT",
                                                  " KEIN COPYRIGHT"};

/// Words in capitals with one blank around each; signs but brackets and what is not ASCII count as blanks.
std::string words_of(std::string_view remark) {
    std::string words = " ";
    for (const char c : in_capitals(remark)) {
        const bool is_kept =
            is_letter(c) || is_digit(c) || c == '(' || c == ')' || static_cast<unsigned char>(c) >= 0x80U;
        if (is_kept)
            words += c;
        else if (words.back() != ' ')
            words += ' ';
    }
    if (words.back() != ' ') words += ' ';
    return words;
}

bool is_year(std::string_view figures) {
    constexpr std::size_t length = 4;
    if (figures.size() < length || !std::ranges::all_of(figures.substr(0, length), is_digit)) return false;
    const std::string_view century = figures.substr(0, 3);
    const bool ends = figures.size() == length || !is_digit(figures[length]);
    return ends && (century == "197" || century == "198" || century == "199" || century == "200" ||
                    century == "201" || century == "202" || century == "203");
}

/// The longest run of letters that begins there, behind figures and blanks.
std::size_t letters_of_next_word(std::string_view words) {
    const auto first = std::ranges::find_if(words, is_letter);
    return static_cast<std::size_t>(std::ranges::find_if_not(first, words.end(), is_letter) - first);
}

std::size_t words_with_letters(std::string_view words) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
        count += is_letter(words[i]) && (i == 0 || !is_letter(words[i - 1])) ? 1 : 0;
    return count;
}

/// Whether C stands for the sign: a year follows, and a name. Without its brackets C may be an address, with
/// a value and a unit.
bool has_letter_for_sign(std::string_view words) {
    struct Sign {
        std::string_view text;
        std::size_t shortest_name, fewest_words;
    };
    constexpr std::array<Sign, 5> signs{
        {{"(C) ", 1, 1}, {"(C)", 1, 1}, {" C) ", 1, 1}, {"(C ", 4, 2}, {" C ", 4, 2}}};
    return std::ranges::any_of(signs, [&](const Sign& sign) {
        const auto at = words.find(sign.text);
        if (at == std::string_view::npos) return false;
        const std::string_view behind = words.substr(at + sign.text.size());
        return is_year(behind) && letters_of_next_word(behind) >= sign.shortest_name &&
               words_with_letters(behind) >= sign.fewest_words;
    });
}

/// The remark that a bracket begins in a text of one line.
std::string_view remark_at(std::string_view line, char close) {
    std::size_t depth = 0; // "(COPYRIGHT (C) 2010)": the control ends it earlier, who wrote it did not
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == line.front()) ++depth;
        if (line[i] == close && --depth == 0) return line.substr(0, i + 1);
    }
    return line;
}

/// Whether a line without its remarks only names a program or a block, or says nothing.
bool does_nothing(std::string_view line) {
    const auto is_sign = [](char c) {
        return c == ' ' || c == '\t' || c == '%' || c == ';' || c == ':' || c == '/' || c == '*' ||
               c == '-' || c == '=';
    };
    while (!line.empty() && is_sign(line.front())) line.remove_prefix(1);
    if (!line.empty() &&
        (line.front() == 'O' || line.front() == 'o' || line.front() == 'N' || line.front() == 'n'))
        line.remove_prefix(1);
    return std::ranges::all_of(line, [&](char c) { return is_digit(c) || is_sign(c); });
}

struct Brackets {
    char open, close;
};

class Head {
  public:
    Head(const Source& source, Brackets brackets)
        : source_(source)
        , text_(source.bytes())
        , brackets_(brackets) {}

    /// The first remark between them that claims rights, before any block that does something.
    [[nodiscard]] std::optional<Span> rights_between(Offset begin, Offset end) const {
        end = std::min(end, begin + most_looked_at);
        for (Offset at = begin; at < end;) {
            const auto line_end = std::min<std::size_t>(text_.find_first_of("\r\n", at), end);
            const std::string_view line = text_.substr(at, line_end - at);
            if (const auto found = rights_in(line)) return Span{at + found->begin, at + found->end};
            if (!does_nothing(without_remarks(line))) return std::nullopt;
            at = static_cast<Offset>(line_end) + 1;
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] std::optional<Span> rights_in(std::string_view line) const {
        for (std::size_t at = line.find(brackets_.open); at != std::string_view::npos;) {
            const std::string_view remark = remark_at(line.substr(at), brackets_.close);
            if (claims_rights(source_.to_utf8(remark)))
                return Span{static_cast<Offset>(at), static_cast<Offset>(at + remark.size())};
            at = line.find(brackets_.open, at + remark.size());
        }
        return std::nullopt;
    }

    [[nodiscard]] std::string without_remarks(std::string_view line) const {
        std::string rest;
        for (std::size_t at = 0; at < line.size();) {
            if (line[at] == brackets_.open)
                at += remark_at(line.substr(at), brackets_.close).size();
            else
                rest += line[at++];
        }
        return rest;
    }

    const Source& source_;
    std::string_view text_;
    Brackets brackets_;
};

} // namespace

bool claims_rights(std::string_view remark) {
    const std::string bracketed = words_of(remark);
    std::string words = bracketed;
    std::ranges::replace_if(
        words, [](char c) { return c == '(' || c == ')'; }, ' ');
    const auto stands = [&](std::string_view text) { return words.find(text) != std::string::npos; };
    if (std::ranges::any_of(others, stands)) return false;
    return std::ranges::any_of(rights, stands) || has_letter_for_sign(bracketed);
}

std::vector<ProgramWithRights> programs_with_rights(const ProgramFile& file) {
    const bool is_square = !file.control->sections.empty();
    const Head head(*file.source, is_square ? Brackets{'[', ']'} : Brackets{'(', ')'});
    std::vector<ProgramWithRights> found;
    std::optional<Span> of_all;
    for (const Program& program : file.programs) {
        if (&program == &file.programs.front()) of_all = head.rights_between(0, program.span.begin);
        const auto remark = of_all ? of_all : head.rights_between(program.span.begin, program.span.end);
        if (remark) found.push_back({program.span, *remark});
    }
    return found;
}

} // namespace maclint
