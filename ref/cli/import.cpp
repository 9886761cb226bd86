#include <cstdio>

#include "commands.hpp"
#include "flatdt/ref/errors.hpp"

#ifndef FLATDT_HAVE_GEMMI

namespace flatdt::ref::cli {

int run_import(const ImportOptions&) {
  throw InvalidInput(
      "this build has no crystal import: it needs the Debian packages gemmi-dev, tao-pegtl-dev, libstb-dev "
      "and zlib1g-dev when flatdt is configured");
}

}  // namespace flatdt::ref::cli

#else

#include "crystal.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "text_files.hpp"

namespace flatdt::ref::cli {
namespace {

/// Printable ASCII without line breaks: what a comment of an instance may safely hold.
std::string printable(const std::string& text) {
  std::string result;
  for (const char c : text) result += c >= ' ' && c <= '~' ? c : '?';
  return result.substr(0, 200);
}

/// The last lines of an instance are its points: each gets the label of its site as a comment.
std::string with_labels(const std::string& text, const std::vector<std::string>& labels) {
  std::size_t at = text.find("\npoints ") + 1;
  at = text.find('\n', at) + 1;
  std::string result = text.substr(0, at);
  for (const std::string& label : labels) {
    const std::size_t end = text.find('\n', at);
    result += text.substr(at, end - at) + "  # " + printable(label) + "\n";
    at = end + 1;
  }
  return result;
}

}  // namespace

int run_import(const ImportOptions& options) {
  const std::string bytes = read_input(options.file);
  try {
    Crystal crystal = read_crystal(bytes, options.file);
    std::string group = crystal.symbol.empty() ? "without a symbol" : crystal.symbol;
    if (!crystal.settings.empty() && crystal.settings.front().symbol != group)
      group += " (" + crystal.settings.front().symbol + ")";
    const ImportedInstance imported =
        instance_of(std::move(crystal), {options.coincident == "merge", options.altloc == "all"});
    const std::size_t slash = options.file.rfind('/');
    std::string text = "# crystal structure " +
                       printable(slash == std::string::npos ? options.file : options.file.substr(slash + 1)) +
                       "\n# group " + printable(group) + ", sites " + std::to_string(imported.labels.size()) +
                       "\n";
    for (const std::string& note : imported.notes) {
      text += "# " + printable(note) + "\n";
      std::fprintf(stderr, "%s: %s\n", options.file.c_str(), printable(note).c_str());
    }
    write_output(options.output, text + with_labels(write_instance(imported.instance), imported.labels));
  } catch (const InvalidInput& error) {
    // Reasons that concern a line already begin with the file.
    const std::string reason = error.what();
    throw InvalidInput(reason.rfind(options.file + ":", 0) == 0 ? reason : options.file + ": " + reason);
  }
  return 0;
}

}  // namespace flatdt::ref::cli

#endif
