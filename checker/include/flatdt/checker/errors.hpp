// What can go wrong other than a condition failing. The library throws these and never prints, exits or
// aborts.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace flatdt::checker {

/// A file breaks FORMAT: what() is "file:line: reason".
class MalformedInput : public std::runtime_error {
 public:
  MalformedInput(const std::string& file, std::size_t line, const std::string& reason)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + reason) {}
};

/// A documented limit of the checker itself was reached; the input may be right.
class ResourceLimit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The checker contradicts itself: a defect of the checker, never of the input.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace flatdt::checker
