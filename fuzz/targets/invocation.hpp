/// A command line and the files it may name, decoded from bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace flatdt::fuzz {

struct Invocation {
  bool is_checker = false;  ///< flatdt-check, else flatdt
  std::vector<std::string> arguments;
  std::string instance;       ///< the content of the file `i`
  std::string triangulation;  ///< the content of the file `t`, and of standard input
};

/// Bytes before the first line feed are arguments separated by NUL or blanks; a byte from 128 on stands for a
/// word of the programs' own. After it come the two files, separated by a NUL. Where one is empty, a small
/// right one is meant. Invariants, so that no input takes long or touches anything but its folder: an
/// argument has no slash and no `x`, at most 40 bytes, and no run of more than two digits; there are at
/// most 12.
[[nodiscard]] Invocation invocation_of(std::span<const std::uint8_t> bytes);

/// The words that bytes from 128 on stand for.
[[nodiscard]] const std::vector<std::string>& words();

}  // namespace flatdt::fuzz
