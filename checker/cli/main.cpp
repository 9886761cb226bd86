// The program flatdt-check.
#include "command_line.hpp"

int main(int argc, char** argv) {
  return flatdt::checker::run_command_line(argc, argv);
}
