//! What programs switch on and off, beside the modal groups.
#include "analyzer/dialect/fanuc/tables.hpp"

namespace maclint::fanuc {
namespace {

// On other controls the code may be a macro of the shop's: it has no P there.
constexpr Switch switches[] = {
    {"limit of look-ahead", "G103 P!0", "G103 P?0", "", Switch::Where::machine, "H07:91; HAAS-LA"},
};

} // namespace

std::span<const Switch> switch_rows() { return switches; }

} // namespace maclint::fanuc
