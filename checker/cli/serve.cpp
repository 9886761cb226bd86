#include "serve.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flatdt/checker/check_texts.hpp"
#include "report.hpp"
#include "time_limit.hpp"

namespace flatdt::checker {
namespace {

constexpr int kDone = 0;
constexpr int kCutShort = 2;
constexpr int kCannotWrite = 3;

constexpr std::string_view kKeyword = "check";
constexpr std::size_t kMaxHeaderBytes = 200;
constexpr std::size_t kMaxIdBytes = 100;
/// What a header may announce at all; more is taken for an error in writing.
constexpr std::size_t kMaxSizeDigits = 15;
constexpr const char* kHeaderForm = "expected 'check ID INSTANCE-BYTES TRIANGULATION-BYTES'";

/// The first line of a request.
struct Header {
  std::string id;
  std::uint64_t instance_bytes = 0;
  std::uint64_t triangulation_bytes = 0;
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t end = std::min(line.find(' '), line.size());
    words.push_back(line.substr(0, end));
    if (end == line.size()) return words;
    line.remove_prefix(end + 1);
  }
}

bool is_id(std::string_view word) {
  return !word.empty() && word.size() <= kMaxIdBytes &&
         std::all_of(word.begin(), word.end(), [](char c) { return 0x21 <= c && c <= 0x7E; });
}

std::optional<std::uint64_t> size_of(std::string_view word) {
  std::uint64_t size = 0;
  if (word.empty() || word.size() > kMaxSizeDigits) return std::nullopt;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), size);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return size;
}

/// Nothing if the line is no header; `id` is set as soon as there is one, for the complaint.
std::optional<Header> parse_header(std::string_view line, std::string& id) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.size() < 2 || !is_id(words[1])) return std::nullopt;
  id = words[1];
  if (words.size() != 4) return std::nullopt;
  const auto instance_bytes = size_of(words[2]);
  const auto triangulation_bytes = size_of(words[3]);
  if (!instance_bytes || !triangulation_bytes) return std::nullopt;
  return Header{id, *instance_bytes, *triangulation_bytes};
}

/// One run of the service.
class Service {
 public:
  Service(std::istream& in, std::FILE* out, const ServeLimits& limits)
      : in_(in), out_(out), limits_(limits) {}

  int run() {
    while (read_line()) {
      const bool is_request = line_ == kKeyword || line_.rfind(std::string(kKeyword) + ' ', 0) == 0;
      if (line_.empty() && in_step_) continue;
      // After a malformed request the lines up to the next header are taken for its texts.
      if (!is_request && !in_step_) continue;
      if (is_request || in_step_) cut_short_ = ended_;
      in_step_ = is_request && answer_request() && !cut_short_;
      if (!is_request) complain("", kHeaderForm);
      if (failed_) return kCannotWrite;
      if (cut_short_) return kCutShort;
    }
    return cut_short_ ? kCutShort : kDone;
  }

 private:
  /// The next line without its line feed, at most kMaxHeaderBytes + 1 bytes of it; false at the end of the
  /// input.
  bool read_line() {
    line_.clear();
    int byte = in_.get();
    if (byte == std::istream::traits_type::eof()) return false;
    for (; byte != '\n' && byte != std::istream::traits_type::eof(); byte = in_.get())
      if (line_.size() <= kMaxHeaderBytes) line_ += static_cast<char>(byte);
    ended_ = byte != '\n';
    return true;
  }

  /// Whether the stream now stands at the end of a request.
  bool answer_request() {
    std::string id;
    const std::optional<Header> header =
        line_.size() <= kMaxHeaderBytes ? parse_header(line_, id) : std::nullopt;
    if (!header) return complain(id, kHeaderForm);
    const std::uint64_t size = header->instance_bytes + header->triangulation_bytes;
    if (size > limits_.bytes) {
      complain(id, "the texts are beyond the limit of " + std::to_string(limits_.bytes) + " bytes");
      return skip(size) && at_end();
    }
    std::string texts;
    if (!read(texts, size) || !at_end()) {
      return complain(id, cut_short_ ? "the input ends within the texts"
                                     : "no line feed after the texts: their sizes are not those announced");
    }
    const std::string_view text = texts;
    judge(id, text.substr(0, header->instance_bytes), text.substr(header->instance_bytes));
    return true;
  }

  void judge(const std::string& id, std::string_view instance, std::string_view triangulation) {
    Verdict late;
    late.reason = "limit of the service: " + std::to_string(limits_.seconds) + " s of processor time";
    const TimeLimit limit(limits_.seconds, service_report(late, id));
    const std::string reply = service_report(check_texts(instance, triangulation), id);
    limit.lift();
    write(reply);
  }

  /// In pieces, so that memory grows with what comes.
  bool read(std::string& texts, std::uint64_t size) {
    constexpr std::uint64_t kPiece = 1 << 20;
    while (texts.size() < size) {
      const std::size_t before = texts.size();
      texts.resize(before + std::min<std::uint64_t>(kPiece, size - before));
      in_.read(texts.data() + before, static_cast<std::streamsize>(texts.size() - before));
      if (!in_) {
        cut_short_ = true;
        return false;
      }
    }
    return true;
  }

  bool skip(std::uint64_t size) {
    in_.ignore(static_cast<std::streamsize>(size));
    cut_short_ = static_cast<std::uint64_t>(in_.gcount()) < size;
    return !cut_short_;
  }

  /// Takes the line feed after the texts; without it the sizes were wrong.
  bool at_end() {
    const int byte = in_.get();
    cut_short_ = byte == std::istream::traits_type::eof();
    if (byte != '\n' && !cut_short_) in_.unget();
    return byte == '\n';
  }

  /// Always false, for the caller to return.
  bool complain(const std::string& id, const std::string& error) {
    write(service_error(id, error));
    return false;
  }

  void write(const std::string& reply) {
    const bool written = std::fwrite(reply.data(), 1, reply.size(), out_) == reply.size();
    if (std::fflush(out_) != 0 || !written) failed_ = true;
  }

  std::istream& in_;
  std::FILE* out_;
  ServeLimits limits_;
  std::string line_;
  bool in_step_ = true;     // the stream stands between two requests
  bool ended_ = false;      // the last line had no line feed: the input ended in it
  bool cut_short_ = false;  // the input ended within a request
  bool failed_ = false;     // a reply could not be written
};

}  // namespace

int serve(std::istream& in, std::FILE* out, const ServeLimits& limits) {
  return Service(in, out, limits).run();
}

}  // namespace flatdt::checker
