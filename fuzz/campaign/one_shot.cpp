#include <csignal>
#include <filesystem>
#include <limits>

#include "command_template.hpp"
#include "implementation.hpp"
#include "text_file.hpp"

namespace flatdt::campaign {
namespace {

constexpr std::uint64_t kTail = 4000;

class OneShot : public Implementation {
 public:
  OneShot(Contact contact, const std::string& folder)
      : contact_(std::move(contact)),
        instance_(folder + "/case.instance"),
        output_(folder + "/case.triangulation"),
        errors_(folder + "/case.errors"),
        from_file_(has_place(contact_.command, "instance")),
        to_file_(has_place(contact_.command, "output")) {}

  Answer answer(const std::string& instance) override {
    // Opening a pipe that the last run left in a file's place would wait for its other end.
    for (const std::string& path : {instance_, output_, errors_}) std::filesystem::remove_all(path);
    write_text(instance_, instance);
    const End end = run_child(filled(contact_.command, instance_, output_), from_file_ ? "" : instance_,
                              to_file_ ? "" : output_, errors_, contact_.limits);
    Answer answer;
    answer.code = end.code;
    answer.errors = read_tail(errors_, kTail);
    switch (end.ending) {
      case Ending::exited:
        answer.kind = end.code == contact_.unsupported_exit ? AnswerKind::unsupported
                      : end.code == 0                       ? AnswerKind::output
                                                            : AnswerKind::exit_status;
        break;
      case Ending::signalled:
        answer.kind = AnswerKind::signal;
        break;
      case Ending::timed_out:
        answer.kind = AnswerKind::timed_out;
        break;
      case Ending::stalled:
        answer.kind = AnswerKind::stalled;
        break;
      case Ending::out_of_memory:
        answer.kind = AnswerKind::out_of_memory;
        break;
      case Ending::flooded:
        answer.kind = AnswerKind::flooded;
        break;
    }
    answer.text = read_tail(output_, std::numeric_limits<std::uint64_t>::max());
    return answer;
  }

 private:
  Contact contact_;
  std::string instance_, output_, errors_;
  bool from_file_, to_file_;
};

}  // namespace

std::unique_ptr<Implementation> make_one_shot(const Contact& contact, const std::string& folder) {
  return std::make_unique<OneShot>(contact, folder);
}

}  // namespace flatdt::campaign
