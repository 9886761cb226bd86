// A stream buffer that gives the bytes of another, and a line break behind the last: CGAL ends some streams
// directly after a token.
#pragma once

#include <array>
#include <streambuf>

namespace flatdt::checker {

class FinalLineBreak : public std::streambuf {
 public:
  explicit FinalLineBreak(std::streambuf& source) : source_(source) {}

 protected:
  int_type underflow() override {
    std::streamsize read =
        ended_ ? 0 : source_.sgetn(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    if (read == 0) {
      if (ended_) return traits_type::eof();
      ended_ = true;
      buffer_[0] = '\n';
      read = 1;
    }
    setg(buffer_.data(), buffer_.data(), buffer_.data() + read);
    return traits_type::to_int_type(buffer_[0]);
  }

 private:
  std::streambuf& source_;
  std::array<char, 1 << 12> buffer_{};
  bool ended_ = false;
};

}  // namespace flatdt::checker
