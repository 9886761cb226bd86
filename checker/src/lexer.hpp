// Tokens of both file formats, with their line numbers.
// Invariants: memory is one buffer, whatever the file; a token lies in it as one piece.
// Source: FORMAT.md, "Lexical rules".
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "flatdt/checker/errors.hpp"
#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

inline constexpr std::size_t kMaxTokenBytes = 4096;

class Lexer {
 public:
  Lexer(std::istream& in, std::string file);

  /// The next token, valid until the next call; empty exactly at the end of the file.
  /// Errors: MalformedInput for a byte that is not allowed, a token too long, or a file ending directly after
  /// a token.
  std::string_view next();

  /// The next token, which must be `word`.
  void expect(std::string_view word);
  /// The next token as [0-9]+ of value in [least, most]; `what` names it in errors.
  std::uint64_t count(std::string_view what, std::uint64_t least, std::uint64_t most) {
    const std::optional<std::uint64_t> value = take_short_count();
    return value && least <= *value && *value <= most ? *value : other_count(value, what, least, most);
  }
  /// The next token as a NUMBER, into `value`.
  void number(std::string_view what, Rational& value);
  /// Fails unless the file has ended.
  void expect_end();

  [[noreturn]] void fail(const std::string& reason) const;
  /// The current token for an error message: quoted, shortened, or "the end of the file".
  [[nodiscard]] std::string found() const;
  /// "file:line" of the current token.
  [[nodiscard]] std::string location() const;

 private:
  /// fail(reason()). The exception is made in a call of its own, so that no string is alive where it is
  /// thrown: each frame with something to destroy costs about as much as the throw itself.
  template <class Reason>
  [[noreturn]] void fail_with(const Reason& reason) const {
    throw located_with(reason);
  }
  template <class Reason>
  [[nodiscard]] MalformedInput located_with(const Reason& reason) const {
    return MalformedInput(file_, token_line_, reason());
  }
  bool refill(std::size_t keep);
  void skip_space();
  [[nodiscard]] std::size_t token_bytes_from_here() const;
  std::optional<std::uint64_t> take_short_count();
  std::uint64_t other_count(std::optional<std::uint64_t> value, std::string_view what, std::uint64_t least,
                            std::uint64_t most);

  std::istream& in_;
  std::string file_;
  std::string_view token_;  // in buffer_
  // Not filled with zeros: files are many and small in campaigns. At filled_ is a byte of no token.
  std::unique_ptr<char[]> buffer_;
  std::size_t position_ = 0;
  std::size_t filled_ = 0;
  std::size_t line_ = 1;        // of the next byte
  std::size_t token_line_ = 1;  // of the token
};

/// Whether the token is a NUMBER: `value` becomes its value, without rounding, or else `fault` says what is
/// wrong. Into a number that is there: a move of GMP's numbers takes memory anew.
[[nodiscard]] bool read_number(std::string_view token, Rational& value, std::string_view& fault);
/// The same. Errors: std::invalid_argument saying what is wrong.
[[nodiscard]] Rational parse_number(std::string_view token);

}  // namespace flatdt::checker
