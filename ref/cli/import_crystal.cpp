/// Reading CIF and mmCIF and looking up group symbols: the only file that sees gemmi, and C++17 (see
/// crystal_text.hpp).
/// Source: gemmi 0.5.7. Traps met: its structures hold doubles, so raw strings of the CIF document are used;
/// it needs the headers of PEGTL and stb; it must be a system include.
#include <zlib.h>

#include <algorithm>
#include <gemmi/cif.hpp>
#include <gemmi/symmetry.hpp>

#include "crystal_text.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

namespace cif = gemmi::cif;

constexpr std::size_t kMaxTextBytes = std::size_t{1} << 26;  // its tokens take some 20 times as much

SettingText setting_of(const gemmi::SpaceGroup& group) {
  SettingText setting;
  setting.symbol = group.xhm();
  for (const gemmi::Op& op : group.operations()) {
    std::array<int, 12> rows{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) rows[4 * i + j] = op.rot[i][j] / gemmi::Op::DEN;
      rows[4 * i + 3] = op.tran[i];
    }
    setting.operations.push_back(rows);
  }
  return setting;
}

std::string without(std::string text, const std::string& unwanted) {
  const auto is_unwanted = [&](char c) { return unwanted.find(c) != std::string::npos; };
  text.erase(std::remove_if(text.begin(), text.end(), is_unwanted), text.end());
  return text;
}

/// The first value among these tags that is not '?' or '.', without quotes; else empty.
std::string value_of(const cif::Block& block, std::initializer_list<const char*> tags) {
  for (const char* tag : tags)
    if (const std::string* value = block.find_value(tag); value != nullptr && !cif::is_null(*value))
      return cif::as_string(*value);
  return {};
}

std::vector<std::string> column_of(cif::Block& block, std::initializer_list<const char*> tags) {
  for (const char* tag : tags) {
    std::vector<std::string> values;
    for (const std::string& value : block.find_values(tag))
      if (!cif::is_null(value)) values.push_back(cif::as_string(value));
    if (!values.empty()) return values;
  }
  return {};
}

/// The matrix of an mmCIF file, if it is complete.
std::vector<std::string> file_matrix(const cif::Block& block) {
  std::vector<std::string> matrix;
  for (const char row : {'1', '2', '3'}) {
    for (const char column : {'1', '2', '3', '0'}) {
      std::string tag = "_atom_sites.fract_transf_";
      tag.append(column == '0' ? "vector[" : "matrix[").append(1, row);
      if (column != '0') tag.append("][").append(1, column);
      tag += ']';
      std::string value = value_of(block, {tag.c_str()});
      if (value.empty() && column == '0') value = "0";
      if (value.empty()) return {};
      matrix.push_back(value);
    }
  }
  return matrix;
}

/// Reads the positions; sites whose coordinates are '?' or '.' (calculated or unobserved) are left out.
bool read_position(const cif::Table::Row& row, int column, SiteText& site) {
  for (int i = 0; i < 3; ++i) {
    if (cif::is_null(row[column + i])) return false;
    site.position[static_cast<std::size_t>(i)] = cif::as_string(row[column + i]);
  }
  return true;
}

void read_small_molecule_sites(cif::Block& block, CrystalText& crystal) {
  cif::Table table = block.find(
      "_atom_site_", {"label", "fract_x", "fract_y", "fract_z", "?disorder_group", "?disorder_assembly"});
  std::size_t without_position = 0;
  for (const cif::Table::Row& row : table) {
    SiteText site;
    site.label = cif::as_string(row[0]);
    if (!read_position(row, 1, site)) {
      ++without_position;
      continue;
    }
    if (row.has2(4)) site.alternative = cif::as_string(row[4]);
    if (row.has2(5)) site.group = cif::as_string(row[5]);
    crystal.sites.push_back(site);
  }
  if (without_position > 0)
    crystal.notes.push_back(std::to_string(without_position) + " sites without coordinates are left out");
}

void read_macromolecule_sites(cif::Block& block, CrystalText& crystal) {
  enum {
    kX = 0,
    kAtom = 3,
    kAlternative,
    kResidue,
    kLabelAsym,
    kAuthAsym,
    kAuthSeq,
    kLabelSeq,
    kInsertion,
    kModel
  };
  cif::Table table =
      block.find("_atom_site.", {"Cartn_x", "Cartn_y", "Cartn_z", "label_atom_id", "?label_alt_id",
                                 "?label_comp_id", "?label_asym_id", "?auth_asym_id", "?auth_seq_id",
                                 "?label_seq_id", "?pdbx_PDB_ins_code", "?pdbx_PDB_model_num"});
  std::string first_model;
  std::size_t later_atoms = 0;
  for (const cif::Table::Row& row : table) {
    const auto text = [&](int column) {
      return row.has2(column) ? cif::as_string(row[column]) : std::string();
    };
    const std::string model = text(kModel);
    if (crystal.sites.empty()) first_model = model;
    if (model != first_model) {
      ++later_atoms;
      continue;
    }
    SiteText site;
    site.alternative = text(kAlternative);
    const std::string chain = row.has2(kAuthAsym) ? text(kAuthAsym) : text(kLabelAsym);
    const std::string number = (row.has2(kAuthSeq) ? text(kAuthSeq) : text(kLabelSeq)) + text(kInsertion);
    site.group = text(kLabelAsym);
    site.group.append("/").append(chain).append("/").append(number);
    site.label = text(kAtom);
    if (!site.alternative.empty()) site.label.append(".").append(site.alternative);
    site.label.append(" ").append(text(kResidue)).append(" ").append(chain).append(number);
    if (!read_position(row, kX, site)) throw InvalidInput("site " + site.label + " has no coordinates");
    crystal.sites.push_back(site);
  }
  if (later_atoms > 0)
    crystal.notes.push_back("only the first model is used: " + std::to_string(later_atoms) +
                            " atoms of later ones are left out");
}

}  // namespace

std::string unpacked(const std::string& bytes) {
  if (bytes.size() > kMaxTextBytes) throw LimitReached("the file has more than 64 MB");
  if (bytes.size() < 2 || bytes[0] != '\x1f' || bytes[1] != '\x8b') return bytes;
  struct Stream {
    z_stream z{};
    ~Stream() { inflateEnd(&z); }
  } stream;
  std::string input = bytes;
  stream.z.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.z.avail_in = static_cast<uInt>(input.size());
  if (inflateInit2(&stream.z, 15 + 16) != Z_OK) throw LimitReached("the gzip decoder cannot start");
  std::string text;
  std::vector<char> buffer(1 << 16);
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    stream.z.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.z.avail_out = static_cast<uInt>(buffer.size());
    state = inflate(&stream.z, Z_NO_FLUSH);
    if (state != Z_OK && state != Z_STREAM_END)
      throw InvalidInput("the gzip'ed file is damaged or cut short");
    text.append(buffer.data(), buffer.size() - stream.z.avail_out);
    if (text.size() > kMaxTextBytes) throw LimitReached("the gzip'ed file unpacks to more than 64 MB");
    // A gzip file may have several members one after another.
    if (state == Z_STREAM_END && stream.z.avail_in > 0) state = inflateReset(&stream.z);
  }
  return text;
}

std::vector<SettingText> settings_of_symbol(const std::string& symbol, double alpha, double gamma) {
  // "P_21" and "P2(1)" are common spellings of P 21.
  const std::string plain = without(symbol, "_()");
  const gemmi::SpaceGroup* meant = gemmi::find_spacegroup_by_name(plain, alpha, gamma);
  if (meant == nullptr) return {};
  std::vector<SettingText> list = {setting_of(*meant)};
  // "P 21" leaves the unique axis open; "P 1 21 1" does not.
  if (gemmi::iequal(without(plain, " "), gemmi::to_lower(without(meant->hm, " ")))) return list;
  for (const gemmi::SpaceGroup& other : gemmi::spacegroup_tables::main)
    if (other.number == meant->number && &other != meant) list.push_back(setting_of(other));
  return list;
}

CrystalText read_cif(const std::string& text, const std::string& file) {
  cif::Document document;
  try {
    document = cif::read_memory(text.data(), text.size(), file.c_str());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InvalidInput(error.what());
  }
  for (cif::Block& block : document.blocks) {
    const bool small = block.has_tag("_atom_site_fract_x");
    if (!small && !block.has_tag("_atom_site.Cartn_x")) continue;
    CrystalText crystal;
    const std::array<const char*, 6> names = {"length_a",    "length_b",   "length_c",
                                              "angle_alpha", "angle_beta", "angle_gamma"};
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string with_underscore = std::string("_cell_") + names[i];
      const std::string with_point = std::string("_cell.") + names[i];
      crystal.cell[i] = value_of(block, {with_underscore.c_str(), with_point.c_str()});
      if (crystal.cell[i].empty())
        throw InvalidInput("no unit cell: data block " + block.name + " has no " + with_underscore);
    }
    crystal.symbol = value_of(
        block, {"_space_group_name_H-M_alt", "_symmetry_space_group_name_H-M", "_space_group_name_H-M_ref",
                "_space_group.name_H-M_alt", "_symmetry.space_group_name_H-M"});
    crystal.operations = column_of(block, {"_space_group_symop_operation_xyz", "_symmetry_equiv_pos_as_xyz",
                                           "_space_group_symop.operation_xyz", "_symmetry_equiv.pos_as_xyz"});
    crystal.cartesian = !small;
    if (small) {
      read_small_molecule_sites(block, crystal);
    } else {
      read_macromolecule_sites(block, crystal);
      crystal.matrix = file_matrix(block);
    }
    return crystal;
  }
  throw InvalidInput("the CIF file has no atom sites");
}

}  // namespace flatdt::ref::cli
