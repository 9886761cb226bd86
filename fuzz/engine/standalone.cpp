/// A fuzz target as a plain program, without an engine: replays inputs, prints them as files, makes inputs of
/// files. See fuzz/README.md.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "laws.hpp"
#include "target.hpp"

bool flatdt::fuzz::asks_all_laws() {
  return true;
}

namespace {

using flatdt::fuzz::Bytes;

constexpr const char* kUsage =
    "usage: %s PATH...                          run every input; a folder means all files below it\n"
    "       %s --print INPUT [PREFIX]           the files an input means, on standard output or as PREFIX.*\n"
    "       %s --encode OUTPUT FILE...          the input that means these files\n"
    "       %s --mutate COUNT SEED PATH...      run COUNT inputs made by the target's mutator from these\n"
    "       %s --time PATH...                   run every input, and print the slowest and the rate\n";

Bytes read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  // A file that cannot be read must not count as one that passed.
  if (!in.is_open() || in.bad()) throw std::runtime_error("cannot read " + path.string());
  return bytes;
}

void write(const std::string& path, const void* data, std::size_t size) {
  std::ofstream out(path, std::ios::binary);
  out.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + path);
}

std::vector<std::filesystem::path> inputs(char** first, char** last) {
  std::vector<std::filesystem::path> files;
  for (char** argument = first; argument != last; ++argument) {
    if (!std::filesystem::is_directory(*argument)) {
      files.emplace_back(*argument);
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*argument))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Of this process, in user mode: a rate by the clock on the wall would depend on what else the machine does.
double processor_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double seconds_for(const Bytes& input) {
  const double start = processor_seconds();
  LLVMFuzzerTestOneInput(input.data(), input.size());
  return processor_seconds() - start;
}

int run_all(const std::vector<std::filesystem::path>& files, bool timed) {
  double total = 0;
  double slowest = 0;
  std::string slowest_name;
  for (const std::filesystem::path& file : files) {
    const Bytes input = read(file);
    std::fprintf(stderr, "%s: ", file.c_str());  // first: a crash is then known by its file
    const double seconds = seconds_for(input);
    std::fprintf(stderr, "done\n");
    total += seconds;
    if (seconds > slowest) {
      slowest = seconds;
      slowest_name = file.string();
    }
  }
  if (timed && total > 0)
    std::printf("%.0f inputs/s, slowest %.3f s: %s\n", static_cast<double>(files.size()) / total, slowest,
                slowest_name.c_str());
  std::printf("%zu inputs run\n", files.size());
  return files.empty() ? 1 : 0;  // nothing run is no success
}

int print(const std::string& input, const char* prefix) {
  for (const flatdt::fuzz::File& file : flatdt::fuzz::print(read(input))) {
    if (prefix != nullptr) {
      write(std::string(prefix) + "." + file.extension, file.text.data(), file.text.size());
    } else {
      std::fwrite(file.text.data(), 1, file.text.size(), stdout);
    }
  }
  return 0;
}

int encode(const std::string& output, char** first, char** last) {
  std::vector<std::string> texts;
  for (char** name = first; name != last; ++name) {
    const Bytes bytes = read(*name);
    texts.emplace_back(bytes.begin(), bytes.end());
  }
  const std::optional<Bytes> input = flatdt::fuzz::encode(texts);
  if (!input) {
    std::fprintf(stderr, "beyond the limits of this target's decoder\n");
    return 3;
  }
  write(output, input->data(), input->size());
  return 0;
}

/// A walk through inputs: each is made from an earlier one, chosen in turn, so that long chains occur.
int mutate(std::size_t count, unsigned seed, const std::vector<std::filesystem::path>& files) {
  constexpr std::size_t kMaxBytes = 8192;
  std::vector<Bytes> pool;
  for (const std::filesystem::path& file : files) pool.push_back(read(file));
  if (pool.empty()) pool.emplace_back();
  double total = 0;
  double slowest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    Bytes& chosen = pool[k % pool.size()];
    Bytes input(kMaxBytes);
    const auto step_seed = static_cast<unsigned>(seed + 2654435761U * k);
    const Bytes& other = pool[(k * 7 + 3) % pool.size()];
    std::size_t size = 0;
    if (k % 8 == 7) {
      size = LLVMFuzzerCustomCrossOver(chosen.data(), chosen.size(), other.data(), other.size(), input.data(),
                                       kMaxBytes, step_seed);
    } else {
      size = std::min(chosen.size(), kMaxBytes);
      std::copy_n(chosen.begin(), size, input.begin());
      size = LLVMFuzzerCustomMutator(input.data(), size, kMaxBytes, step_seed);
    }
    input.resize(size);
    write("last-input", input.data(), input.size());
    const double seconds = seconds_for(input);
    total += seconds;
    if (seconds > slowest) {
      slowest = seconds;
      write("slowest-input", input.data(), input.size());
    }
    chosen = input;
  }
  std::printf("%zu inputs made and run, seed %u; %.3f s of processor time in the target, slowest %.3f s\n",
              count, seed, total, slowest);
  return 0;
}

int run(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "--print" && (argc == 3 || argc == 4)) return print(argv[2], argc == 4 ? argv[3] : nullptr);
  if (command == "--encode" && argc >= 4) return encode(argv[2], argv + 3, argv + argc);
  if (command == "--mutate" && argc >= 4)
    return mutate(std::stoul(argv[2]), static_cast<unsigned>(std::stoul(argv[3])),
                  inputs(argv + 4, argv + argc));
  if (command == "--time" && argc >= 3) return run_all(inputs(argv + 2, argv + argc), true);
  if (argc < 2 || command[0] == '-') {
    std::fprintf(stderr, kUsage, argv[0], argv[0], argv[0], argv[0], argv[0]);
    return 2;
  }
  return run_all(inputs(argv + 1, argv + argc), false);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
}
