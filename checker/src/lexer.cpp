#include "lexer.hpp"

#include <cstdio>
#include <stdexcept>
#include <utility>

#include "flatdt/checker/errors.hpp"

namespace flatdt::checker {
namespace {

constexpr int kEnd = -1;
constexpr std::size_t kBufferBytes = 1 << 16;

bool is_space(int c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}  // tab LF VT FF CR are 9..13

}  // namespace

Lexer::Lexer(std::istream& in, std::string file) : in_(in), file_(std::move(file)), buffer_(kBufferBytes) {}

// Reads through the stream buffer: a read error is an exception there, while istream::read would only set a
// flag.
int Lexer::get() {
  if (position_ == filled_) {
    filled_ = static_cast<std::size_t>(in_.rdbuf()->sgetn(buffer_.data(), kBufferBytes));
    position_ = 0;
    if (filled_ == 0) return kEnd;
  }
  return static_cast<unsigned char>(buffer_[position_++]);
}

std::string_view Lexer::next() {
  token_.clear();
  token_line_ = line_;
  for (int c = get();; c = get()) {
    if (c == '#') {
      while (c != '\n' && c != kEnd) c = get();
      if (c == '\n') ++line_;
      if (c == kEnd || !token_.empty()) return token_;
      token_line_ = line_;
    } else if (c == kEnd) {
      if (!token_.empty())
        fail("the file ends directly after " + found() + "; white space must follow (cut short?)");
      return token_;
    } else if (is_space(c)) {
      if (c == '\n') ++line_;
      if (!token_.empty()) return token_;
      token_line_ = line_;
    } else {
      if (c < 0x21 || c > 0x7E) {
        char hex[16];
        std::snprintf(hex, sizeof hex, "0x%02X", static_cast<unsigned>(c));
        fail(std::string("byte ") + hex +
             " is not allowed outside comments; only 0x21..0x7E and white space are");
      }
      if (token_.size() == kMaxTokenBytes) fail("token longer than 4096 bytes: " + found());
      token_ += static_cast<char>(c);
    }
  }
}

void Lexer::expect(std::string_view word) {
  if (next() != word) fail("expected '" + std::string(word) + "', found " + found());
}

std::uint64_t Lexer::count(std::string_view what, std::uint64_t least, std::uint64_t most) {
  const std::string_view digits = next();
  bool valid = !digits.empty();
  std::uint64_t value = 0;
  for (const char c : digits) {
    valid = valid && c >= '0' && c <= '9';
    if (valid && value <= most)
      value = 10 * value + static_cast<std::uint64_t>(c - '0');  // saturates above most
  }
  if (!valid) fail("expected " + std::string(what) + " ([0-9]+), found " + found());
  if (value < least || value > most) {
    fail(std::string(what) + " must be from " + std::to_string(least) + " to " + std::to_string(most) +
         ", found " + found());
  }
  return value;
}

Rational Lexer::number(std::string_view what) {
  const std::string_view token = next();
  if (token.empty()) fail("expected " + std::string(what) + ", found " + found());
  try {
    return parse_number(token);
  } catch (const std::invalid_argument& error) {
    fail(std::string(what) + ": " + error.what() + ", found " + found());
  }
}

void Lexer::expect_end() {
  if (!next().empty()) fail("expected the end of the file, found " + found());
}

void Lexer::fail(const std::string& reason) const {
  throw MalformedInput(file_, token_line_, reason);
}

std::string Lexer::found() const {
  constexpr std::size_t kShown = 40;
  if (token_.empty()) return "the end of the file";
  return "'" + token_.substr(0, kShown) + (token_.size() > kShown ? "...'" : "'");
}

std::string Lexer::location() const {
  return file_ + ":" + std::to_string(token_line_);
}

}  // namespace flatdt::checker
