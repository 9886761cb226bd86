/// A command line and the files it may name, decoded from bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace flatdt::fuzz {

enum class Program : std::uint8_t { reference, checker, campaign };

/// "flatdt", "flatdt-check", "flatdt-campaign".
[[nodiscard]] const char* name_of(Program program);

struct Invocation {
  Program program = Program::reference;
  std::vector<std::string> arguments;
  std::string instance;       ///< the content of the file `i`
  std::string triangulation;  ///< the content of the file `t`, and of standard input
};

/// The first byte chooses the program. Bytes before the first line feed are arguments separated by NUL or
/// blanks; a byte from 128 on stands for a word of the programs' own. After it come the two files, separated
/// by a NUL. Where one is empty, a small right one is meant. Invariants, so that no input takes long or
/// touches anything but its folder: an argument has no slash and no `x`, at most 40 bytes, and no run of more
/// than two digits; there are at most 12.
[[nodiscard]] Invocation invocation_of(std::span<const std::uint8_t> bytes);

/// The words that bytes from kFirstWord on stand for.
inline constexpr std::uint8_t kFirstWord = 128;
[[nodiscard]] const std::vector<std::string>& words();

}  // namespace flatdt::fuzz
