/// The folder of a minimised failure: everything needed to look at it and to see it again.
///
///     instance           the shrunk instance
///     output             what the implementation wrote for it, if anything
///     verdict.json       what the checker says of that
///     reason.txt         messages
///     original.instance  the case as it was drawn
///     picture.svg        drawn by `flatdt draw`, if it could be (in space: picture.html)
///     reproduce          a script for sh: runs the command on the instance, then flatdt-check
#pragma once

#include <string>

#include "capabilities.hpp"
#include "implementation.hpp"
#include "judge.hpp"

namespace flatdt::campaign {

struct Failure {
  std::string original;  // instance files
  std::string shrunk;
  int dimension = 0;
  Answer answer;  // to the shrunk instance
  Judgement judgement;
  std::string origin;  // a line that says which case of which campaign it is
};

/// Writes the bundle. `flatdt`: the program that draws; empty: no picture. Errors: std::runtime_error.
void write_bundle(const std::string& folder, const Failure& failure, const Contact& contact, Claim claim,
                  const std::string& flatdt);

}  // namespace flatdt::campaign
