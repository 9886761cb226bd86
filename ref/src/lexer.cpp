#include "lexer.hpp"

#include <algorithm>

namespace flatdt::ref {
namespace {

// Not std::isspace and friends: those depend on the locale.
bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');  // tab, LF, VT, FF, CR
}

/// A token as it is shown in messages; tokens may be 4,096 bytes long.
std::string quoted(std::string_view token) {
  constexpr std::size_t kShown = 40;
  return '"' + std::string(token.substr(0, kShown)) + (token.size() > kShown ? "...\"" : "\"");
}

}  // namespace

Lexer::Lexer(std::string_view text, std::string file_name) : text_(text), file_name_(std::move(file_name)) {}

std::string What::text() const {
  return number ? std::string(name) + " " + std::to_string(*number) : std::string(name);
}

InvalidInput Lexer::located(const std::string& reason) const {
  return InvalidInput(file_name_ + ":" + std::to_string(token_line_) + ": " + reason);
}

void Lexer::fail(const std::string& reason) const {
  throw located(reason);
}

void Lexer::advance() {
  looked_ = true;
  token_ = {};
  const char* const end = text_.data() + text_.size();
  const char* at = text_.data() + position_;
  for (; at != end && (is_space(*at) || *at == '#'); ++at) {
    if (*at == '#') at = std::find(at, end, '\n');
    if (at == end) break;
    if (*at == '\n') ++line_;
  }
  token_line_ = line_;
  const char* const start = at;
  for (; at != end && !is_space(*at) && *at != '#'; ++at) {
    if (*at < 0x21 || *at > 0x7E)
      fail_with([byte = static_cast<unsigned char>(*at)] {
        return "byte " + std::to_string(byte) +
               " outside a comment: only white space and printable ASCII are allowed";
      });
    if (static_cast<std::size_t>(at - start) == kMaxTokenBytes)
      fail_with(
          [] { return "a token is longer than the limit of " + std::to_string(kMaxTokenBytes) + " bytes"; });
  }
  position_ = static_cast<std::size_t>(at - text_.data());
  token_ = {start, static_cast<std::size_t>(at - start)};
  if (!token_.empty() && position_ == text_.size())
    fail_with([this] {
      return "the file ends directly after " + quoted(token_) +
             ", so it may have been cut short: end it with a line break";
    });
}

std::string_view Lexer::peek() {
  if (!looked_) advance();
  return token_;
}

bool Lexer::accept(std::string_view keyword) {
  if (peek() != keyword) return false;
  looked_ = false;
  return true;
}

void Lexer::expect(std::string_view keyword) {
  if (accept(keyword)) return;
  fail_with([this, keyword] {
    return (token_.empty() ? "the file ends" : quoted(token_) + " stands") + " where \"" +
           std::string(keyword) + "\" must stand";
  });
}

std::string_view Lexer::word(const What& what) {
  if (peek().empty()) fail_with([&what] { return "the file ends where " + what.text() + " must stand"; });
  looked_ = false;
  return token_;
}

Rational Lexer::number(const What& what) {
  const std::string_view token = word(what);
  NumberFault fault{};
  if (std::optional<Rational> value = number_of(token, fault)) return *std::move(value);
  fail_with([&] { return what.text() + ": " + quoted(token) + " " + text_of(fault); });
}

std::uint64_t Lexer::natural(const What& what, std::uint64_t maximum, std::string_view limit) {
  const std::string_view token = word(what);
  if (!is_digits(token, 10))
    fail_with([&] { return what.text() + ": " + quoted(token) + " is not a number of digits 0 to 9 only"; });
  const auto value = natural_up_to(token, maximum);
  if (!value)
    fail_with([&] {
      return what.text() + ": " + quoted(token) + " is " + std::string(limit) + " " + std::to_string(maximum);
    });
  return *value;
}

std::uint64_t Lexer::count(const What& what, std::uint64_t maximum) {
  return natural(what, maximum, "beyond the limit of");
}

std::uint64_t Lexer::index(const What& what, std::uint64_t bound) {
  if (bound == 0) fail(what.text() + ": there is nothing that an index could mean");
  return natural(what, bound - 1, "out of range: they are numbered from 0 to");
}

Isometry Lexer::isometry(int dimension, const What& what) {
  Isometry g{Matrix(dimension), Vector(dimension)};
  for (int i = 0; i < dimension; ++i) {
    for (int j = 0; j < dimension; ++j) g.linear(i, j) = number(what);
    g.translation[i] = number(what);
  }
  return g;
}

void Lexer::expect_end(std::string_view last) {
  if (!peek().empty())
    fail_with([&] { return quoted(token_) + " stands after the last " + std::string(last); });
}

}  // namespace flatdt::ref
