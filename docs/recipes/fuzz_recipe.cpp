/// A libFuzzer target of one's own: bytes are points of a 16 x 16 grid on the square torus, full of ties.
///   clang++ -g -O1 -fsanitize=fuzzer,address fuzz_recipe.cpp my_triangulation.cpp \
///       $(pkg-config --cflags --libs flatdt-checker flatdt-ref) -o fuzz_recipe && ./fuzz_recipe -runs=10000
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "flatdt/checker/check_texts.hpp"
#include "my_triangulation.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::size_t points = std::min<std::size_t>(size, 12);
  if (points == 0) return 0;
  std::string instance =
      "flatdt-instance 1\ndimension 2\nmanifold torus\npoints " + std::to_string(points) + "\n";
  for (std::size_t i = 0; i < points; ++i)
    instance += std::to_string(data[i] % 16) + "/16 " + std::to_string(data[i] / 16) + "/16\n";

  const std::string triangulation = my_triangulation(instance);
  const auto verdict = flatdt::checker::check_texts(instance, triangulation);
  if (verdict.outcome != flatdt::checker::Outcome::verified) {
    // Both files, so that `flatdt-check` shows the witness.
    std::fprintf(stderr, "%s\n--- instance\n%s--- triangulation\n%s", to_string(verdict.outcome).data(),
                 instance.c_str(), triangulation.c_str());
    std::abort();
  }
  return 0;
}
