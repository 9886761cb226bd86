/// The columns of PDB files. Read here and not through doubles, so that decimals stay exact; columns beyond
/// 66 (old files have the entry name and a line number there) are never looked at. Source: wwPDB, File Format
/// Contents Guide 3.3: CRYST1, SCALEn, ATOM, HETATM, MODEL, REMARK 290.
#include <algorithm>
#include <cctype>

#include "crystal.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

std::string_view trimmed(std::string_view s) {
  const std::size_t begin = s.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return s.substr(begin, s.find_last_not_of(' ') - begin + 1);
}

class PdbReader {
 public:
  PdbReader(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  Crystal read() {
    bool in_first_model = true;
    while (!rest_.empty()) {
      next_line();
      const std::string_view record = trimmed(columns(1, 6));
      if (record == "END" || (record == "ENDMDL" && !crystal_.sites.empty())) in_first_model = false;
      if (record == "CRYST1" && crystal_.cell[0].empty()) read_cell();
      if (record.substr(0, 5) == "SCALE" && record.size() == 6) read_scale(record[5]);
      if (record == "REMARK") read_remark();
      if (record != "ATOM" && record != "HETATM") continue;
      if (in_first_model) {
        read_atom();
      } else {
        ++later_atoms_;
      }
    }
    if (crystal_.cell[0].empty()) throw InvalidInput(file_ + ": no unit cell: there is no CRYST1 record");
    if (scale_rows_ == 0b111) crystal_.fractional_from_cartesian = scale_;
    if (later_atoms_ > 0)
      crystal_.notes.push_back("only the first model is used: " + std::to_string(later_atoms_) +
                               " atoms of later ones are left out");
    crystal_.cartesian = true;
    return std::move(crystal_);
  }

 private:
  void next_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
  }

  /// Columns first to last, counted from 1 as in the format guide; fewer where the line is shorter.
  [[nodiscard]] std::string_view columns(std::size_t first, std::size_t last) const {
    return line_.size() < first ? std::string_view{} : line_.substr(first - 1, last - first + 1);
  }

  [[nodiscard]] std::string place() const { return file_ + ":" + std::to_string(number_) + ": "; }

  [[nodiscard]] Rational number(std::size_t first, std::size_t last, const char* what) const {
    return exact_decimal(trimmed(columns(first, last)), place() + what);
  }

  void read_cell() {
    for (std::size_t i = 0; i < 3; ++i) {
      crystal_.cell[i] = trimmed(columns(7 + 9 * i, 15 + 9 * i));
      crystal_.cell[3 + i] = trimmed(columns(34 + 7 * i, 40 + 7 * i));
    }
    for (const std::string& text : crystal_.cell) exact_decimal(text, place() + "cell parameter");
    crystal_.symbol = trimmed(columns(56, 66));
  }

  void read_scale(char row) {
    if (row < '1' || row > '3') return;
    const int i = row - '1';
    for (int j = 0; j < 3; ++j) {
      const auto first = std::size_t{11} + std::size_t{10} * static_cast<std::size_t>(j);
      scale_.linear(i, j) = number(first, first + 9, "SCALE");
    }
    scale_.translation[i] = number(46, 55, "SCALE");
    scale_rows_ |= 1U << static_cast<unsigned>(i);
  }

  /// REMARK 290 lists the operations as lines of a number NNNMMM and a triplet.
  void read_remark() {
    if (columns(8, 10) != "290") return;
    const std::string_view rest = trimmed(columns(11, 80));
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (digits < 4 || rest.find(',') == std::string_view::npos) return;
    crystal_.operations.emplace_back(trimmed(rest.substr(digits)));
  }

  void read_atom() {
    if (line_.size() < 54) throw InvalidInput(place() + "the line ends before the coordinates do");
    CrystalSite site;
    site.alternative = trimmed(columns(17, 17));
    site.group = columns(22, 27);  // chain, number and insertion code of the residue
    site.label = std::string(trimmed(columns(13, 16))) + (site.alternative.empty() ? "" : ".") +
                 site.alternative + " " + std::string(trimmed(columns(18, 20))) + " " +
                 std::string(trimmed(columns(22, 22))) + std::string(trimmed(columns(23, 27)));
    for (int i = 0; i < 3; ++i) {
      const auto first = std::size_t{31} + std::size_t{8} * static_cast<std::size_t>(i);
      site.position[i] = number(first, first + 7, "coordinate");
    }
    crystal_.sites.push_back(site);
  }

  std::string_view rest_, line_;
  std::string file_;
  std::size_t number_ = 0, later_atoms_ = 0;
  Isometry scale_{Matrix(3), Vector(3)};
  unsigned scale_rows_ = 0;  // one bit for each row read
  Crystal crystal_;
};

bool is_pdb(std::string_view text) {
  for (const std::string record : {"CRYST1", "ATOM  ", "HETATM"})
    if (text.substr(0, 6) == record || text.find("\n" + record) != std::string_view::npos) return true;
  return false;
}

}  // namespace

bool is_cif(std::string_view text) {
  while (!text.empty()) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return false;
    text.remove_prefix(start);
    if (text[0] != '#') {
      std::string word(text.substr(0, 5));
      std::transform(word.begin(), word.end(), word.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      return word == "data_";
    }
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
  return false;
}

Crystal read_pdb(std::string_view text, const std::string& file) {
  if (!is_pdb(text))
    throw InvalidInput("the file is neither CIF (no data block) nor PDB (no CRYST1, ATOM or HETATM record)");
  return PdbReader(text, file).read();
}

}  // namespace flatdt::ref::cli
