#include "lexer.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "flatdt/checker/errors.hpp"

namespace flatdt::checker {
namespace {

constexpr std::size_t kBufferBytes = 1 << 13;
static_assert(kBufferBytes > kMaxTokenBytes);

constexpr char kEnd = '\0';  // of the bytes in the buffer

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}  // tab LF VT FF CR are 9..13

bool is_token_byte(char c) {
  return c >= 0x21 && c <= 0x7E && c != '#';
}

}  // namespace

Lexer::Lexer(std::istream& in, std::string file)
    : in_(in), file_(std::move(file)), buffer_(std::make_unique_for_overwrite<char[]>(kBufferBytes + 1)) {
  buffer_[0] = kEnd;
}

/// Moves the bytes from `keep` on to the front of the buffer and reads more behind them; false at the end of
/// the file. At most kMaxTokenBytes are kept, so there is room.
/// Reads through the stream buffer: a read error is an exception there, while istream::read would only set a
/// flag.
bool Lexer::refill(std::size_t keep) {
  std::copy(buffer_.get() + keep, buffer_.get() + filled_, buffer_.get());
  position_ -= keep;
  filled_ -= keep;
  const auto room = static_cast<std::streamsize>(kBufferBytes - filled_);
  const std::streamsize read = in_.rdbuf()->sgetn(buffer_.get() + filled_, room);
  filled_ += static_cast<std::size_t>(read);
  buffer_[filled_] = kEnd;
  return read > 0;
}

/// Goes to the next byte that is neither white space nor in a comment, or to the end of the file.
void Lexer::skip_space() {
  bool comment = false;
  do {
    const char* const end = buffer_.get() + filled_;
    for (const char* at = buffer_.get() + position_; at != end; ++at) {
      if (*at == '\n') {
        ++line_;
        comment = false;
      } else if (*at == '#') {
        comment = true;
      } else if (!comment && !is_space(*at)) {
        position_ = static_cast<std::size_t>(at - buffer_.get());
        return;
      }
    }
    position_ = filled_;
  } while (refill(position_));
}

/// The number of bytes of a token from position_ on that are in the buffer.
std::size_t Lexer::token_bytes_from_here() const {
  const char* const begin = buffer_.get() + position_;
  const char* const end = buffer_.get() + filled_;
  return static_cast<std::size_t>(std::find_if_not(begin, end, is_token_byte) - begin);
}

std::string_view Lexer::next() {
  token_ = {};
  skip_space();
  token_line_ = line_;
  std::size_t length = token_bytes_from_here();
  while (position_ + length == filled_ && length <= kMaxTokenBytes) {
    if (!refill(position_)) break;
    length = token_bytes_from_here();
  }
  token_ = {buffer_.get() + position_, std::min(length, kMaxTokenBytes)};
  if (length > kMaxTokenBytes) fail_with([this] { return "token longer than 4096 bytes: " + found(); });
  position_ += length;
  if (position_ < filled_) {
    const char c = buffer_[position_];
    if (!is_space(c) && c != '#')
      fail_with([c] {
        char hex[16];
        std::snprintf(hex, sizeof hex, "0x%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
        return std::string("byte ") + hex +
               " is not allowed outside comments; only 0x21..0x7E and white space are";
      });
  } else if (!token_.empty()) {
    fail_with([this] {
      return "the file ends directly after " + found() + "; white space must follow (cut short?)";
    });
  }
  return token_;
}

void Lexer::expect(std::string_view word) {
  if (next() != word) fail_with([&] { return "expected '" + std::string(word) + "', found " + found(); });
}

/// The most frequent tokens: white space, at most 18 digits (a value below 10^18) and white space, all of it
/// in the buffer. Anything else is left to next(), and nothing of it consumed.
std::optional<std::uint64_t> Lexer::take_short_count() {
  constexpr std::ptrdiff_t kMostDigits = 18;
  const char* at = buffer_.get() + position_;
  std::size_t lines = 0;
  for (; is_space(*at); ++at) lines += *at == '\n' ? 1 : 0;
  const char* const begin = at;
  std::uint64_t value = 0;  // without meaning for more digits
  for (; *at >= '0' && *at <= '9'; ++at) value = 10 * value + static_cast<std::uint64_t>(*at - '0');
  const std::ptrdiff_t digits = at - begin;
  if (digits == 0 || digits > kMostDigits || !is_space(*at)) return std::nullopt;
  token_ = {begin, static_cast<std::size_t>(digits)};
  token_line_ = line_ += lines;
  position_ = static_cast<std::size_t>(at - buffer_.get());
  return value;
}

/// `value`: of the token, if that is taken.
std::uint64_t Lexer::other_count(std::optional<std::uint64_t> value, std::string_view what,
                                 std::uint64_t least, std::uint64_t most) {
  if (!value) {
    value = 0;
    const std::string_view digits = next();
    bool valid = !digits.empty();
    for (const char c : digits) {
      valid = valid && c >= '0' && c <= '9';
      if (valid && *value <= most)
        *value = 10 * *value + static_cast<std::uint64_t>(c - '0');  // saturates above most
    }
    if (!valid) fail_with([&] { return "expected " + std::string(what) + " ([0-9]+), found " + found(); });
  }
  if (*value < least || *value > most) {
    fail_with([&] {
      return std::string(what) + " must be from " + std::to_string(least) + " to " + std::to_string(most) +
             ", found " + found();
    });
  }
  return *value;
}

void Lexer::number(std::string_view what, Rational& value) {
  const std::string_view token = next();
  if (token.empty()) fail_with([&] { return "expected " + std::string(what) + ", found " + found(); });
  std::string_view fault;
  if (!read_number(token, value, fault))
    fail_with([&] { return std::string(what) + ": " + std::string(fault) + ", found " + found(); });
}

void Lexer::expect_end() {
  if (!next().empty()) fail_with([this] { return "expected the end of the file, found " + found(); });
}

void Lexer::fail(const std::string& reason) const {
  throw MalformedInput(file_, token_line_, reason);
}

std::string Lexer::found() const {
  constexpr std::size_t kShown = 40;
  if (token_.empty()) return "the end of the file";
  return "'" + std::string(token_.substr(0, kShown)) + (token_.size() > kShown ? "...'" : "'");
}

std::string Lexer::location() const {
  return file_ + ":" + std::to_string(token_line_);
}

}  // namespace flatdt::checker
