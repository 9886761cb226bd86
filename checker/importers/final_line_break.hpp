// A stream buffer that gives the bytes of another, and a line break behind the last if that is none: CGAL
// ends some streams directly after a token.
#pragma once

#include <array>
#include <streambuf>

namespace flatdt::checker {

class FinalLineBreak : public std::streambuf {
 public:
  explicit FinalLineBreak(std::streambuf& source) : source_(source) {}

 protected:
  int_type underflow() override {
    std::streamsize read = source_.sgetn(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    if (read == 0) {
      if (last_ == '\n') return traits_type::eof();
      buffer_[0] = '\n';
      read = 1;
    }
    last_ = buffer_[static_cast<std::size_t>(read) - 1];
    setg(buffer_.data(), buffer_.data(), buffer_.data() + read);
    return traits_type::to_int_type(buffer_[0]);
  }

 private:
  std::streambuf& source_;
  std::array<char, 1 << 12> buffer_{};
  char last_ = '\n';  // an empty stream stays one
};

}  // namespace flatdt::checker
