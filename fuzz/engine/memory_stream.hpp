/// A stream that reads a text where it is: std::istringstream would copy it.
#pragma once

#include <istream>
#include <streambuf>
#include <string>

namespace flatdt::fuzz {

class MemoryBuffer : public std::streambuf {
 public:
  explicit MemoryBuffer(const std::string& text) {
    char* const start =
        const_cast<char*>(text.data());  // streams have no other way to say that they only read
    setg(start, start, start + text.size());
  }
};

/// The text must outlive it.
class MemoryStream : private MemoryBuffer, public std::istream {
 public:
  explicit MemoryStream(const std::string& text) : MemoryBuffer(text), std::istream(this) {}
};

}  // namespace flatdt::fuzz
