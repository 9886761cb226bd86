/// Tokens of the two file formats and the exact numbers they stand for (FORMAT: lexical rules and limits).
/// Invariants: nothing is rounded; a byte outside comments is white space or 0x21..0x7E; every token read was
/// followed by white space or a comment; memory does not grow with a count in the text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/isometry.hpp"
#include "number.hpp"

namespace flatdt::ref {

inline constexpr std::size_t kMaxTokenBytes = 4096;

/// How messages call a token: "the metric", or "element 3". A text is made only where one is printed. What is
/// named must outlive it.
struct What {
  What(const char* text) : name(text) {}  // NOLINT(google-explicit-constructor)
  What(std::string_view text, std::uint64_t k) : name(text), number(k) {}
  [[nodiscard]] std::string text() const;

  std::string_view name;
  std::optional<std::uint64_t> number;
};

/// A cursor over the tokens of one text. The text must outlive it.
/// Errors: every member throws InvalidInput "file:line: reason" when the text breaks a rule.
class Lexer {
 public:
  /// `file_name` is used in messages only.
  Lexer(std::string_view text, std::string file_name);

  /// The next token, left in place; empty at the end of the text.
  std::string_view peek();
  /// Reads the next token if it equals `keyword`.
  bool accept(std::string_view keyword);
  /// Reads the next token, which must equal `keyword`.
  void expect(std::string_view keyword);
  /// Reads any token. `what` names it in messages, as in all members below.
  std::string_view word(const What& what);
  Rational number(const What& what);
  /// A COUNT in [0, maximum].
  std::uint64_t count(const What& what, std::uint64_t maximum);
  /// An INDEX in [0, bound).
  std::uint64_t index(const What& what, std::uint64_t bound);
  /// An affine map: the d x (d+1) matrix [R|t] row by row.
  Isometry isometry(int dimension, const What& what);
  /// No token may be left. `last` names the last section.
  void expect_end(std::string_view last);

  /// Bytes of the text after the token last read or looked at.
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - position_; }
  /// The line of the token last read or looked at.
  [[nodiscard]] int line() const { return static_cast<int>(token_line_); }
  /// Throws InvalidInput with the file and the line of the token last read or looked at.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  /// fail(reason()). The exception is made in a call of its own, so that no string is alive where it is
  /// thrown: each frame with something to destroy costs about as much as the throw itself.
  template <class Reason>
  [[noreturn]] void fail_with(const Reason& reason) const {
    throw located_with(reason);
  }
  template <class Reason>
  [[nodiscard]] InvalidInput located_with(const Reason& reason) const {
    return located(reason());
  }
  [[nodiscard]] InvalidInput located(const std::string& reason) const;
  void advance();
  std::uint64_t natural(const What& what, std::uint64_t maximum, std::string_view limit);

  std::string_view text_;
  std::string file_name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;        // of position_
  std::size_t token_line_ = 1;  // of token_, or of the end of the text
  std::string_view token_;      // the token looked at, empty if none is
  bool looked_ = false;         // token_ is the answer of peek()
};

}  // namespace flatdt::ref
