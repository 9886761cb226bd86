/// The line that a message of a parser names.
#pragma once

#include <cstdlib>
#include <string>

namespace flatdt::fuzz {

/// The number in "f:NUMBER: reason"; 0 if there is none. The file is called "f".
inline long line_of(const std::string& message) {
  return message.rfind("f:", 0) == 0 ? std::strtol(message.c_str() + 2, nullptr, 10) : 0;
}

}  // namespace flatdt::fuzz
