/// Typed errors of ref. The library throws these and never prints, exits or aborts.
#pragma once

#include <stdexcept>
#include <string>

namespace flatdt::ref {

/// The caller's data is wrong: a file that breaks the grammar, an inadmissible group, a name that does not
/// exist. The message names the offending element or point and says what would be right.
class InvalidInput : public std::runtime_error {
 public:
  /// The section of an instance that is at fault, where the grammar is right and the meaning is not.
  enum class Section { none, manifold, generators, metric };

  explicit InvalidInput(const std::string& reason, Section section = Section::none)
      : std::runtime_error(reason), section_(section) {}
  [[nodiscard]] Section section() const { return section_; }

 private:
  Section section_;
};

/// A documented limit of this program was reached; the input may well be right.
class LimitReached : public std::runtime_error {
 public:
  explicit LimitReached(const std::string& reason) : std::runtime_error(reason) {}
};

/// Our bug: an invariant that the mathematics guarantees does not hold.
class InternalError : public std::logic_error {
 public:
  explicit InternalError(const std::string& law) : std::logic_error("internal error: " + law) {}
};

/// Always-on assertion of a law; throws InternalError.
inline void ensure(bool condition, const char* law) {
  if (!condition) throw InternalError(law);
}

}  // namespace flatdt::ref
