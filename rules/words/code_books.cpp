//! The explicit list of the chapters of codes.
#include "rules/words/code_book.hpp"

#include <array>

namespace maclint {
namespace code_books {

extern const CodeBook fanuc_mill_moves;
extern const CodeBook fanuc_mill_data;
extern const CodeBook fanuc_mill_modes;
extern const CodeBook fanuc_mill_cycles;
extern const CodeBook fanuc_lathe_moves;
extern const CodeBook fanuc_lathe_data;
extern const CodeBook fanuc_lathe_roughing;
extern const CodeBook fanuc_lathe_cycles;
extern const CodeBook fanuc_lathe_drilling;
extern const CodeBook fanuc_functions;
extern const CodeBook nct_mill;
extern const CodeBook haas_mill;
extern const CodeBook haas_mill_cycles;
extern const CodeBook haas_mill_functions;
extern const CodeBook haas_lathe;
extern const CodeBook haas_lathe_cycles;
extern const CodeBook haas_lathe_functions;
extern const CodeBook haas_functions;
extern const CodeBook dinplus_contours;
extern const CodeBook dinplus_c_contours;
extern const CodeBook dinplus_figures;
extern const CodeBook dinplus_y_contours;
extern const CodeBook dinplus_moves_and_feeds;
extern const CodeBook dinplus_compensation;
extern const CodeBook dinplus_turning_cycles;
extern const CodeBook dinplus_threads_and_undercuts;
extern const CodeBook dinplus_drilling;
extern const CodeBook dinplus_c_axis;
extern const CodeBook dinplus_milling;
extern const CodeBook dinplus_measuring;
extern const CodeBook dinplus_machine;
extern const CodeBook dinplus_older_functions;
extern const CodeBook dinplus_m_functions;

} // namespace code_books

std::span<const CodeBook* const> all_code_books() {
    using namespace code_books;
    static constexpr std::array list = {
        &fanuc_mill_moves,
        &fanuc_mill_data,
        &fanuc_mill_modes,
        &fanuc_mill_cycles,
        &fanuc_lathe_moves,
        &fanuc_lathe_data,
        &fanuc_lathe_roughing,
        &fanuc_lathe_cycles,
        &fanuc_lathe_drilling,
        &fanuc_functions,
        &nct_mill,
        &haas_mill,
        &haas_mill_cycles,
        &haas_mill_functions,
        &haas_lathe,
        &haas_lathe_cycles,
        &haas_lathe_functions,
        &haas_functions,
        &dinplus_contours,
        &dinplus_c_contours,
        &dinplus_figures,
        &dinplus_y_contours,
        &dinplus_moves_and_feeds,
        &dinplus_compensation,
        &dinplus_turning_cycles,
        &dinplus_threads_and_undercuts,
        &dinplus_drilling,
        &dinplus_c_axis,
        &dinplus_milling,
        &dinplus_measuring,
        &dinplus_machine,
        &dinplus_older_functions,
        &dinplus_m_functions,
    };
    return list;
}

} // namespace maclint
