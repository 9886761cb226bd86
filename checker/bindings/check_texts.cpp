#include "flatdt/checker/check_texts.hpp"

#include <istream>
#include <streambuf>

#include "flatdt/checker/input.hpp"
#include "judged.hpp"

namespace flatdt::checker {
namespace {

/// A stream that reads a text where it is.
class TextStream : private std::streambuf, public std::istream {
 public:
  explicit TextStream(std::string_view text) : std::istream(static_cast<std::streambuf*>(this)) {
    char* const start = const_cast<char*>(text.data());  // streams cannot say that they only read
    setg(start, start, start + text.size());
  }
};

}  // namespace

Verdict check_texts(std::string_view instance_text, std::string_view triangulation_text,
                    const TextNames& names) {
  return judged([&] {
    TextStream instance_stream(instance_text);
    const Instance instance = parse_instance(instance_stream, names.instance);
    TextStream triangulation_stream(triangulation_text);
    return check(instance, parse_triangulation(triangulation_stream, names.triangulation, instance));
  });
}

}  // namespace flatdt::checker
