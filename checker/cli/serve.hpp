// flatdt-check --serve: many checks in one process, over a line protocol.   Source: docs/serve.md.
#pragma once

#include <cstdint>
#include <cstdio>
#include <istream>

namespace flatdt::checker {

/// Limits for one request.
struct ServeLimits {
  std::uint64_t bytes = std::uint64_t{256} << 20;  ///< of both texts together
  unsigned seconds = 60;                           ///< of processor time; 0: no limit
};

/// Answers requests until the input ends, one line of JSON each.
/// Returns: the exit code: 0 the input ended between requests, 2 within one, 3 a reply could not be written.
///          A check that exceeds the time limit ends the process with 3, after its reply.
/// Memory:  grows with what was read of one request, never with the sizes it announces.
[[nodiscard]] int serve(std::istream& in, std::FILE* out, const ServeLimits& limits);

}  // namespace flatdt::checker
