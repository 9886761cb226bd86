#include <cstdio>

#include "commands.hpp"
#include "flatdt/ref/errors.hpp"
#include "text_files.hpp"

#ifndef FLATDT_HAVE_GEMMI

namespace flatdt::ref::cli {

std::string import_text(const std::string&, const ImportOptions&) {
  throw InvalidInput(
      "this build has no crystal import: it needs the Debian packages gemmi-dev, tao-pegtl-dev, libstb-dev "
      "and zlib1g-dev when flatdt is configured");
}

int run_import(const ImportOptions& options) {
  write_output(options.output, import_text({}, options));
  return 0;
}

}  // namespace flatdt::ref::cli

#else

#include "crystal.hpp"
#include "crystal_text.hpp"
#include "flatdt/ref/instance_format.hpp"

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

/// Numbers of the text of a CIF file become exact.
Crystal exact_crystal(CrystalText text) {
  Crystal crystal;
  static const std::array<const char*, 6> kNames = {"a", "b", "c", "alpha", "beta", "gamma"};
  for (std::size_t i = 0; i < 6; ++i) {
    exact_decimal(text.cell[i], std::string("cell parameter ") + kNames[i]);
    crystal.cell[i] = text.cell[i].substr(0, text.cell[i].find('('));
  }
  crystal.symbol = std::move(text.symbol);
  crystal.operations = std::move(text.operations);
  crystal.cartesian = text.cartesian;
  if (!text.matrix.empty()) {
    Isometry map{Matrix(3), Vector(3)};
    for (int i = 0; i < 3; ++i) {
      const auto entry = [&](int j) {
        return exact_decimal(text.matrix[static_cast<std::size_t>(4) * static_cast<std::size_t>(i) +
                                         static_cast<std::size_t>(j)],
                             "_atom_sites.fract_transf");
      };
      for (int j = 0; j < 3; ++j) map.linear(i, j) = entry(j);
      map.translation[i] = entry(3);
    }
    crystal.fractional_from_cartesian = map;
  }
  constexpr std::size_t kMaxSites = 1'000'000;
  if (text.sites.size() > kMaxSites)
    throw LimitReached("the file has " + std::to_string(text.sites.size()) + " atom sites; the limit is " +
                       std::to_string(kMaxSites));
  for (const SiteText& site : text.sites) {
    CrystalSite exact{site.label, site.group, site.alternative, Vector(3)};
    for (int i = 0; i < 3; ++i)
      exact.position[i] =
          exact_decimal(site.position[static_cast<std::size_t>(i)], "coordinate of site " + site.label);
    crystal.sites.push_back(exact);
  }
  crystal.notes = std::move(text.notes);
  return crystal;
}

void look_up_symbol(Crystal& crystal) {
  if (crystal.symbol.empty()) return;
  const double alpha = exact_decimal(crystal.cell[3], "cell parameter alpha").to_double();
  const double gamma = exact_decimal(crystal.cell[5], "cell parameter gamma").to_double();
  for (const SettingText& text : settings_of_symbol(crystal.symbol, alpha, gamma)) {
    GroupSetting setting{text.symbol, {}};
    for (const std::array<int, 12>& rows : text.operations) {
      Isometry g{Matrix(3), Vector(3)};
      for (int i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(4) * static_cast<std::size_t>(i);
        for (int j = 0; j < 3; ++j) g.linear(i, j) = rows[row + static_cast<std::size_t>(j)];
        g.translation[i] = Rational(Integer(rows[row + 3]), Integer(24));
      }
      setting.operations.push_back(g);
    }
    crystal.settings.push_back(setting);
  }
}

}  // namespace

std::string import_text(const std::string& bytes, const ImportOptions& options) {
  try {
    const std::string source = unpacked(bytes);
    Crystal crystal =
        is_cif(source) ? exact_crystal(read_cif(source, options.file)) : read_pdb(source, options.file);
    look_up_symbol(crystal);
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
    return text + with_labels(write_instance(imported.instance), imported.labels);
  } catch (const InvalidInput& error) {
    // Reasons that concern a line already begin with the file.
    const std::string reason = error.what();
    throw InvalidInput(reason.rfind(options.file + ":", 0) == 0 ? reason : options.file + ": " + reason);
  } catch (const LimitReached& limit) {
    throw LimitReached(options.file + ": " + limit.what());
  }
}

int run_import(const ImportOptions& options) {
  write_output(options.output, import_text(read_input(options.file), options));
  return 0;
}

}  // namespace flatdt::ref::cli

#endif
