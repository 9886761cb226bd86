#include "text_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

std::string reason() {
  return std::strerror(errno);
}

void write_all(int descriptor, std::string_view text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t n = ::write(descriptor, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw LimitReached("writing the result failed: " + reason());
    done += static_cast<std::size_t>(n);
  }
}

void write_all(int descriptor, const Writer& write) {
  write([descriptor](std::string_view piece) { write_all(descriptor, piece); });
}

/// A device or a pipe cannot be renamed over: it is written to directly.
bool is_device(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode);
}

void write_to_device(const std::string& path, const Writer& write) {
  struct stat info {};
  const bool is_folder = ::stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode);
  const int device = is_folder ? -1 : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (device < 0) throw InvalidInput(path + ": cannot be written: not a file");
  try {
    write_all(device, write);
  } catch (...) {
    ::close(device);
    throw;
  }
  ::close(device);
}

/// The file a symbolic link leads to, if there is one; else the path itself.
std::string without_links(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> target(::realpath(path.c_str(), nullptr), std::free);
  return target ? target.get() : path;
}

/// A temporary file beside `path` that takes its place when renamed, and else is removed.
class PendingFile {
 public:
  explicit PendingFile(const std::string& path)
      : path_(without_links(path)), temporary_(path_.substr(0, path_.rfind('/') + 1) + ".flatdt-XXXXXX") {
    if (path.empty()) throw InvalidInput("the name of an output is empty");
    descriptor_ = ::mkstemp(temporary_.data());
    if (descriptor_ < 0) throw InvalidInput(path + ": cannot be created: " + reason());
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    ::close(descriptor_);
    if (!renamed_) ::unlink(temporary_.c_str());
  }
  void write(const Writer& text) const {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(descriptor_, 0666 & ~mask) != 0) throw LimitReached(path_ + ": " + reason());
    write_all(descriptor_, text);
    if (::fsync(descriptor_) != 0 && errno != EINVAL) throw LimitReached(path_ + ": " + reason());
  }
  void rename() {
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) throw LimitReached(path_ + ": " + reason());
    renamed_ = true;
  }

 private:
  std::string path_;
  std::string temporary_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

Output Output::of_text(std::string path, std::string text) {
  return {std::move(path),
          [text = std::move(text)](const std::function<void(std::string_view)>& sink) { sink(text); }};
}

std::string read_input(const std::string& path) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 31;
  int descriptor = STDIN_FILENO;
  if (path != "-") {
    descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw InvalidInput(path + ": cannot be read: " + reason());
  }
  std::string text;
  // A file that grows or shrinks meanwhile is read all the same.
  struct stat info {};
  if (::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 0)
    text.reserve(static_cast<std::size_t>(std::min<off_t>(info.st_size, kMaxBytes)) + 1);
  std::vector<char> buffer(1 << 16);
  ssize_t n = 0;
  while ((n = ::read(descriptor, buffer.data(), buffer.size())) != 0) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const InvalidInput error(path + ": cannot be read: " + reason());
      if (path != "-") ::close(descriptor);
      throw error;
    }
    // An endless input (a device, a pipe) must end in an error, not in memory exhaustion.
    if (text.size() > kMaxBytes) {
      if (path != "-") ::close(descriptor);
      throw LimitReached(path + ": more than 2^31 bytes of input");
    }
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  if (path != "-") ::close(descriptor);
  return text;
}

void write_outputs(const std::vector<Output>& outputs) {
  std::vector<std::unique_ptr<PendingFile>> files;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    for (std::size_t j = 0; j < i; ++j)
      if (outputs[j].path == output.path)
        throw InvalidInput(output.path == "-" ? "two outputs would go to standard output"
                                              : output.path + ": two outputs would go to this file");
    if (output.path != "-" && !is_device(output.path)) {
      files.push_back(std::make_unique<PendingFile>(output.path));
      files.back()->write(output.write);
    }
  }
  for (const Output& output : outputs)
    if (output.path == "-")
      write_all(STDOUT_FILENO, output.write);
    else if (is_device(output.path))
      write_to_device(output.path, output.write);
  for (const auto& file : files) file->rename();
}

void write_output(const std::string& path, const std::string& text) {
  write_outputs({Output::of_text(path, text)});
}

}  // namespace flatdt::ref::cli
