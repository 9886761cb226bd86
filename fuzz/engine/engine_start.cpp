/// What targets do once where an engine runs them.
#include <cstdlib>

#include "laws.hpp"
#include "limb_pool.hpp"

bool flatdt::fuzz::asks_all_laws() {
  static const bool all = std::getenv("FLATDT_FUZZ_ALL_LAWS") != nullptr;
  return all;
}

/// Called by libFuzzer and by the drivers of AFL++ and honggfuzz before the first input. With
/// FLATDT_FUZZ_MALLOC in the environment numbers come from malloc.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (std::getenv("FLATDT_FUZZ_MALLOC") == nullptr) flatdt::fuzz::use_limb_pool();
  return 0;
}
