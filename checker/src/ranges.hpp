// Work on ranges of indices, several at a time.
#pragma once

#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace flatdt::checker {

/// Calls work(r, begin, end) for r in 0..jobs-1 with ranges that partition 0..size-1 in ascending order, each
/// in a thread of its own, the first in this one; returns when all have returned. Of the exceptions that
/// leave work, the one of the first range is thrown. Requires: jobs > 0.
template <class Work>
void in_ranges(std::size_t size, unsigned jobs, const Work& work) {
  std::vector<std::exception_ptr> failures(jobs);
  const auto run = [&](unsigned r) {
    try {
      work(r, size * r / jobs, size * (r + 1) / jobs);
    } catch (...) {
      failures[r] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(jobs);
  for (unsigned r = 1; r < jobs; ++r) {
    try {
      threads.emplace_back(run, r);
    } catch (const std::exception&) {  // no thread, or no memory for one: the others must still be joined
      run(r);
    }
  }
  run(0);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace flatdt::checker
