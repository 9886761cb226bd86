/// The program `flatdt`.
#include <csignal>

#include "command_line.hpp"

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is a failed write, reported as such
  return flatdt::ref::cli::run_command_line(argc, argv);
}
