#include <poll.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string_view>

#include "descriptor.hpp"
#include "implementation.hpp"
#include "text_file.hpp"

namespace flatdt::campaign {
namespace {

constexpr std::uint64_t kTail = 4000;
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLook{20};  // at the limits, whatever the child writes meanwhile
constexpr std::size_t kMarkBytes = 6;           // of the longest line `end` with the line break before it

void make_nonblocking(int descriptor) {
  fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

struct Reply {
  std::string_view lines;  // before the first line `end`
  std::string_view rest;   // behind it
};

/// Nothing as long as the line `end` has not come. The search starts at `from`, a place before it.
std::optional<Reply> complete(std::string_view text, std::size_t from) {
  for (const std::string_view mark : {"end\n", "end\r\n"})
    if (text.starts_with(mark)) return Reply{text.substr(0, 0), text.substr(mark.size())};
  for (const std::string_view mark : {"\nend\n", "\nend\r\n"})
    if (const std::size_t at = text.find(mark, from); at != std::string_view::npos)
      return Reply{text.substr(0, at + 1), text.substr(at + mark.size())};
  return std::nullopt;
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

class Persistent : public Implementation {
 public:
  Persistent(Contact contact, const std::string& folder)
      : contact_(std::move(contact)), errors_(folder + "/case.errors") {}

  Answer answer(const std::string& instance) override {
    if (child_ && has_more_to_say()) child_.reset();
    if (!child_) start();
    child_->start_clock();
    const std::string request = instance + (instance.ends_with('\n') ? "end\n" : "\nend\n");
    std::string text;
    const Ending ending = exchange(request, text);
    const std::optional<Reply> reply = complete(text, 0);
    if (ending != Ending::exited || !reply) return failure(ending, text);
    if (!is_blank(reply->rest)) {
      child_.reset();
      return {AnswerKind::output, 0, std::move(text), {}};  // malformed: a line `end` stands in it
    }
    std::string lines(reply->lines);
    if (lines.starts_with("unsupported")) return {AnswerKind::unsupported, 0, {}, std::move(lines)};
    if (lines.starts_with("failed")) return {AnswerKind::exit_status, 1, {}, std::move(lines)};
    return {AnswerKind::output, 0, std::move(lines), {}};
  }

 private:
  void start() {
    Pipe requests, replies;
    std::filesystem::remove_all(errors_);  // it may be a pipe by now
    const Descriptor errors = open_file(errors_, O_WRONLY | O_CREAT | O_TRUNC);
    child_.emplace(contact_.command, requests.read_end.get(), replies.write_end.get(), errors.get(),
                   contact_.limits);
    to_child_ = std::move(requests.write_end);
    from_child_ = std::move(replies.read_end);
    make_nonblocking(to_child_.get());
    make_nonblocking(from_child_.get());
  }

  /// Has the child written anything since its answer was complete? It would be taken for the answer to the
  /// next instance.
  bool has_more_to_say() {
    char buffer[1 << 16];  // as much as a pipe holds
    const ssize_t got = read(from_child_.get(), buffer, sizeof buffer);
    return got > 0 && !is_blank({buffer, static_cast<std::size_t>(got)});
  }

  /// Writes the request and reads until the reply is complete, the child has ended or breaks a limit. Exited:
  /// one of the first two.
  Ending exchange(std::string_view request, std::string& reply) {
    char buffer[1 << 16];
    Clock::time_point looked = Clock::now();
    for (;;) {
      pollfd events[3] = {{from_child_.get(), POLLIN, 0},
                          {child_->end_descriptor(), POLLIN, 0},
                          {request.empty() ? -1 : to_child_.get(), POLLOUT, 0}};
      const int ready = poll(events, 3, static_cast<int>(kLook.count()));
      // By the clock: a child that writes now and then, or takes the request slowly, always is ready.
      if (const Clock::time_point now = Clock::now(); now - looked >= kLook) {
        looked = now;
        if (const Ending broken = child_->broken_limit(); broken != Ending::exited) return broken;
      }
      if (ready <= 0) continue;
      if (events[2].revents != 0) {
        const ssize_t written = write(to_child_.get(), request.data(), request.size());
        if (written > 0) request.remove_prefix(static_cast<std::size_t>(written));
        if (written < 0 && errno != EAGAIN && errno != EINTR) request = {};  // it has closed its input
      }
      if (events[0].revents != 0) {
        const ssize_t got = read(from_child_.get(), buffer, sizeof buffer);
        if (got > 0) reply.append(buffer, static_cast<std::size_t>(got));
        if (contact_.limits.output_bytes != 0 && reply.size() > contact_.limits.output_bytes)
          return Ending::flooded;
        if (got > 0) {
          const std::size_t before = reply.size() - static_cast<std::size_t>(got);
          if (complete(reply, before > kMarkBytes ? before - kMarkBytes : 0)) return Ending::exited;
        }
        if (got == 0) return Ending::exited;  // it has closed its output
      } else if (events[1].revents != 0) {
        return Ending::exited;
      }
    }
  }

  /// The child has ended, or must; the next instance meets a new one.
  Answer failure(Ending ending, std::string& reply) {
    // A child that has closed its output and goes on is waited for, within its limits.
    const End end = ending == Ending::exited ? child_->wait() : child_->kill(ending);
    child_.reset();
    AnswerKind kind = AnswerKind::exit_status;  // whatever the status: it owed an answer
    if (end.ending == Ending::signalled) kind = AnswerKind::signal;
    if (end.ending == Ending::timed_out) kind = AnswerKind::timed_out;
    if (end.ending == Ending::stalled) kind = AnswerKind::stalled;
    if (end.ending == Ending::out_of_memory) kind = AnswerKind::out_of_memory;
    if (end.ending == Ending::flooded) kind = AnswerKind::flooded;
    return {kind, end.code, std::move(reply), read_tail(errors_, kTail)};
  }

  Contact contact_;
  std::string errors_;
  Descriptor to_child_, from_child_;
  std::optional<Child> child_;
};

}  // namespace

std::unique_ptr<Implementation> make_persistent(const Contact& contact, const std::string& folder) {
  return std::make_unique<Persistent>(contact, folder);
}

}  // namespace flatdt::campaign
