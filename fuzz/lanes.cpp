//! Two ways to read a block that must agree: the plain lane and the grammar, the parse cache and the parser.
#include "fuzz/harness.hpp"
#include "tests/dialect/both_lanes.hpp"
#include "tests/dialect/cached_trees.hpp"

using namespace maclint;

namespace {

void compare_trees(std::string_view text, const test::BlockLanguage& language) {
    test::TreeComparison comparison(language);
    std::set<std::string> blocks;
    test::add_blocks(language, text, blocks);
    for (const std::string& block : blocks)
        if (const auto difference = comparison.difference(block)) fuzz::fail(*difference);
}

void compare_lanes(std::string_view text, std::string_view control) {
    if (const auto difference = test::difference_of_lanes(text, control, "generated.nc"))
        fuzz::fail(*difference);
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    switch (fuzz::choice(text, 3)) {
    case 0: compare_lanes(text, "fanuc"); break;
    case 1: compare_lanes(text, "fanuc-lathe"); break;
    default: compare_lanes("MACHINING\n" + std::string(text), "dinplus"); break;
    }
    compare_trees(text, test::fanuc_blocks);
    compare_trees(text, test::dinplus_blocks);
    return 0;
}
