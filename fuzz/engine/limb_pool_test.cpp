// The pool under the checks of the engines: numbers are what they would be without it, and when the program
// ends its memory is no leak, of which the leak checker complains by the exit code. That follows no pointers
// in poisoned memory, such as those from a free block to the next.
#include <gmpxx.h>

#include <cstdio>
#include <vector>

#include "limb_pool.hpp"

namespace {

/// Of every size in the pool and above; several chunks of most sizes.
mpz_class sum_of_powers() {
  std::vector<mpz_class> powers;
  for (unsigned k = 0; k < 20'000; ++k) {
    powers.emplace_back(1);
    powers.back() <<= k % 2500;
  }
  mpz_class sum;
  for (const mpz_class& power : powers) sum += power;
  return sum;
}

}  // namespace

int main() {
  const mpz_class expected = sum_of_powers();
  flatdt::fuzz::use_limb_pool();
  if (sum_of_powers() != expected) {
    std::fputs("limb_pool_test: wrong sum\n", stderr);
    return 1;
  }
  return 0;
}
