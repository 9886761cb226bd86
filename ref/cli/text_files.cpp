#include "text_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

std::string reason() {
  return std::strerror(errno);
}

void write_all(int descriptor, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t n = ::write(descriptor, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw LimitReached("writing the result failed: " + reason());
    done += static_cast<std::size_t>(n);
  }
}

}  // namespace

std::string read_input(const std::string& path) {
  int descriptor = STDIN_FILENO;
  if (path != "-") {
    descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw InvalidInput(path + ": cannot be read: " + reason());
  }
  std::string text;
  std::vector<char> buffer(1 << 16);
  ssize_t n = 0;
  while ((n = ::read(descriptor, buffer.data(), buffer.size())) != 0) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const std::string why = reason();
      if (path != "-") ::close(descriptor);
      throw InvalidInput(path + ": cannot be read: " + why);
    }
    // An endless input (a device, a pipe) must end in an error, not in memory exhaustion.
    constexpr std::size_t kMaxBytes = std::size_t{1} << 31;
    if (text.size() > kMaxBytes) {
      if (path != "-") ::close(descriptor);
      throw LimitReached(path + ": more than 2^31 bytes of input");
    }
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  if (path != "-") ::close(descriptor);
  return text;
}

void write_output(const std::string& path, const std::string& text) {
  if (path == "-") {
    write_all(STDOUT_FILENO, text);
    return;
  }
  // A device or a pipe cannot be renamed over: write to it directly.
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode)) {
    const int device = S_ISDIR(info.st_mode) ? -1 : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (device < 0) throw InvalidInput(path + ": cannot be written: not a file");
    try {
      write_all(device, text);
    } catch (...) {
      ::close(device);
      throw;
    }
    ::close(device);
    return;
  }
  std::string temporary = path + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) throw InvalidInput(path + ": cannot be created: " + reason());
  try {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(descriptor, 0666 & ~mask) != 0) throw LimitReached(path + ": " + reason());
    write_all(descriptor, text);
    if (::fsync(descriptor) != 0 && errno != EINVAL) throw LimitReached(path + ": " + reason());
    if (::rename(temporary.c_str(), path.c_str()) != 0) throw LimitReached(path + ": " + reason());
  } catch (...) {
    ::close(descriptor);
    ::unlink(temporary.c_str());
    throw;
  }
  ::close(descriptor);
}

}  // namespace flatdt::ref::cli
