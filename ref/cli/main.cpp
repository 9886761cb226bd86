/// The program `flatdt`.
#include <csignal>

#include "command_line.hpp"

int main(int argc, char** argv) {
  // A closed pipe and a limit of file sizes are failed writes, reported as such.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return flatdt::ref::cli::run_command_line(argc, argv);
}
