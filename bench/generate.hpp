//! Programs made to measure: deterministic NC text of any size and shape for benchmarks and scaling tests.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace maclint::bench {

/// A 3D finishing job as a CAM system posts it: raster passes of short lines in X Y Z, arcs at the turns, a
/// tool change every 20,000 lines. Every second tool has N numbers. At least `bytes` long, at most one pass
/// more.
[[nodiscard]] std::string cam_output(std::size_t bytes);

/// The same with an N number at every block, and one jump into the middle of a tool's work.
[[nodiscard]] std::string numbered_cam_output(std::size_t bytes);

/// A DIN PLUS program whose machining part has nothing but numbered blocks of literal words. At least `bytes`
/// long.
[[nodiscard]] std::string plain_turning(std::size_t bytes);

/// A tape of macro programs of 30 to 60 lines (checks, saved modal state, loops, jumps, canned cycles), every
/// one callable with G65. Each calls only the helper macros at the head of the tape. At least `bytes` long,
/// at most one program more.
[[nodiscard]] std::string macro_code(std::size_t bytes);

/// A DIN PLUS program: contour, main part, and local subprograms of some 35 blocks (vacancy tests, loops,
/// choices, contour references), each called from the main part. At least `bytes` long.
[[nodiscard]] std::string expert_program(std::size_t bytes);

/// The same programs as a folder holds them: every helper in a file of its own, the rest in files of
/// `bytes` each, all with different numbers, that call the helpers across files.
[[nodiscard]] std::vector<std::string> macro_files(std::size_t files, std::size_t bytes);

/// One main program with `jumps` GOTO statements: short ones forward, long ones forward, counted ones
/// backward.
[[nodiscard]] std::string one_program_with_jumps(std::size_t jumps);

/// One main program that assigns `variables` different variables (common, then by index) and reads each of
/// them, with a branch after every eighth.
[[nodiscard]] std::string one_program_with_variables(std::size_t variables);

/// A main program and `depth` macros under it, each called by the one before.
[[nodiscard]] std::string call_chain(std::size_t depth);

/// Exactly `bytes` bytes that look like NC text to a lexer and to nobody else; the same for the same seed.
[[nodiscard]] std::string line_noise(std::size_t bytes, unsigned seed);

} // namespace maclint::bench
