#include "adapter.hpp"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::adapters {
namespace {

constexpr int kUsage = 2;
constexpr int kInternal = 3;
constexpr int kUnsupported = 4;

int loop(const Answer& answer) {
  std::string instance;
  for (std::string line; std::getline(std::cin, line);) {
    if (line != "end") {
      instance += line + "\n";
      continue;
    }
    try {
      std::cout << answer(ref::parse_instance(instance, "instance"));
    } catch (const Unsupported& reason) {
      std::cout << "unsupported " << reason.what() << "\n";
    } catch (const std::exception& error) {
      std::string text = error.what();
      for (char& c : text)
        if (c == '\n') c = ' ';
      std::cout << "failed " << text << "\n";
    }
    std::cout << "end\n" << std::flush;
    instance.clear();
  }
  return 0;
}

int once(const std::string& instance_path, const std::string& output_path, const Answer& answer) {
  std::ifstream in(instance_path, std::ios::binary);
  if (!in) throw ref::InvalidInput("cannot open " + instance_path);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::string result = answer(ref::parse_instance(text, instance_path));
  std::ofstream out(output_path, std::ios::binary);
  out << result;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + output_path);
  return 0;
}

}  // namespace

int run_adapter(const std::string& name, const std::vector<std::string>& files, const Answer& answer) {
  try {
    if (files.size() == 1 && files[0] == "--loop") return loop(answer);
    if (files.size() == 2) return once(files[0], files[1], answer);
    std::fprintf(stderr, "usage: %s [OPTION]... INSTANCE OUTPUT | --loop\n", name.c_str());
    return kUsage;
  } catch (const Unsupported& reason) {
    std::fprintf(stderr, "%s: not supported: %s\n", name.c_str(), reason.what());
    return kUnsupported;
  } catch (const ref::InvalidInput& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return kUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return kInternal;
  }
}

}  // namespace flatdt::adapters
