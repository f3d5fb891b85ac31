//! Compares the products in the words of each block.
#include "rules/numbers/ratio_as_length_twice_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/conditions/conditions.hpp"

#include <optional>
#include <string_view>

namespace maclint::rules {
namespace {

bool is_ratio(Operation operation) { return operation == Operation::sine || operation == Operation::cosine; }

/// A length times the sine or cosine of an angle.
struct Product {
    ExpressionId length, ratio;
};

/// What is found of products in an expression.
struct Products {
    std::optional<Product> product;
    int ratios = 0;
};

void gather(const Program& program, ExpressionId id, Products& found) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply == nullptr) return;
    found.ratios += is_ratio(apply->operation) ? 1 : 0;
    const auto operands = program.operands_of(*apply);
    if (apply->operation == Operation::multiply)
        for (const std::size_t i : {0U, 1U}) {
            const auto* ratio = std::get_if<Apply>(&program.expressions[operands[i]].node);
            if (ratio != nullptr && is_ratio(ratio->operation))
                found.product = Product{operands[1 - i], operands[i]};
        }
    for (const ExpressionId operand : operands) gather(program, operand, found);
}

std::optional<Product> only_product(const Program& program, const Word& word) {
    const auto* id = std::get_if<ExpressionId>(&word.value);
    if (id == nullptr) return std::nullopt;
    Products found;
    gather(program, *id, found);
    return found.ratios == 1 ? found.product : std::nullopt;
}

/// Whether the words stand for two axes of one kind: X and Y, I and K.
bool are_of_two_axes(std::string_view first, std::string_view second) {
    const auto are_both_in = [&](std::string_view letters) {
        return letters.find(first) != std::string_view::npos &&
               letters.find(second) != std::string_view::npos;
    };
    return first.size() == 1 && second.size() == 1 && first != second &&
           (are_both_in("XYZ") || are_both_in("UVW") || are_both_in("IJK"));
}

} // namespace

std::vector<SameRatioTwice> find_same_ratios(const Program& program) {
    std::vector<SameRatioTwice> found;
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto block = stored_block(program, item);
        if (!block) continue;
        for (std::size_t i = 0; i + 1 < block->words.size(); ++i) {
            const Word& one = block->words[i];
            const Word& two = block->words[i + 1];
            const auto first = only_product(program, one);
            const auto second = first && are_of_two_axes(one.address, two.address)
                                    ? only_product(program, two)
                                    : std::nullopt;
            if (second && queries::same_expression(program, first->length, second->length) &&
                queries::same_expression(program, first->ratio, second->ratio))
                found.push_back(
                    {one.span, two.span,
                     std::get<Apply>(program.expressions[first->ratio].node).operation == Operation::cosine});
        }
    }
    return found;
}

} // namespace maclint::rules
