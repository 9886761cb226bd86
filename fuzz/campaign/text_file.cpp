#include "text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "descriptor.hpp"

namespace flatdt::campaign {

std::string read_text(const std::string& path) {
  if (!std::filesystem::exists(path)) return {};
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot open " + path);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw std::runtime_error("cannot read " + path);
  return text;
}

// The type is that of what was opened: what a name stands for may change at any time. Opening a pipe waits
// for its other end unless told not to.
std::string read_tail(const std::string& path, std::uint64_t most) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (file.get() < 0 || fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  const auto size = static_cast<std::uint64_t>(status.st_size);
  std::string text(std::min(size, most), '\0');
  std::size_t filled = 0;
  while (filled < text.size()) {
    const ssize_t n = pread(file.get(), text.data() + filled, text.size() - filled,
                            static_cast<off_t>(size - text.size() + filled));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;  // shortened meanwhile
    filled += static_cast<std::size_t>(n);
  }
  text.resize(filled);
  return text;
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace flatdt::campaign
