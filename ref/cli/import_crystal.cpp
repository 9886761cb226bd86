/// Reading CIF and mmCIF and looking up group symbols: the only file that sees gemmi.
/// Source: gemmi 0.5.7. Traps met: its structures hold doubles, so raw strings of the CIF document are used;
/// it needs the headers of PEGTL and stb; it must be a system include.
#include <zlib.h>

#include <algorithm>
#include <gemmi/cif.hpp>
#include <gemmi/symmetry.hpp>

#include "crystal.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

namespace cif = gemmi::cif;

constexpr std::size_t kMaxTextBytes = std::size_t{1} << 28;

/// The text itself, unpacked if it is gzip'ed. Errors: InvalidInput if it is damaged, LimitReached beyond
/// 256 MB (a few kilobytes can unpack to gigabytes).
std::string unpacked(const std::string& bytes) {
  if (bytes.size() < 2 || bytes[0] != '\x1f' || bytes[1] != '\x8b') return bytes;
  struct Stream {
    z_stream z{};
    ~Stream() { inflateEnd(&z); }
  } stream;
  std::string input = bytes;
  stream.z.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.z.avail_in = static_cast<uInt>(std::min(input.size(), kMaxTextBytes));
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
    if (text.size() > kMaxTextBytes) throw LimitReached("the gzip'ed file unpacks to more than 256 MB");
    // A gzip file may have several members one after another.
    if (state == Z_STREAM_END && stream.z.avail_in > 0) state = inflateReset(&stream.z);
  }
  return text;
}

std::vector<Isometry> operations_of_setting(const gemmi::SpaceGroup& group) {
  std::vector<Isometry> list;
  for (const gemmi::Op& op : group.operations()) {
    Isometry g{Matrix(3), Vector(3)};
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      for (int j = 0; j < 3; ++j) g.linear(i, j) = op.rot[row][static_cast<std::size_t>(j)] / gemmi::Op::DEN;
      g.translation[i] = Rational(Integer(op.tran[row]), Integer(int{gemmi::Op::DEN}));
    }
    list.push_back(g);
  }
  return list;
}

std::string without_spaces(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '_'; });
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// See Crystal::settings. "P 21" leaves the unique axis open; "P 1 21 1" does not.
std::vector<GroupSetting> settings_of_symbol(const Crystal& crystal) {
  // "P_21" and "P2(1)" are common spellings of P 21.
  std::string symbol = crystal.symbol;
  std::erase_if(symbol, [](char c) { return c == '_' || c == '(' || c == ')'; });
  // Angles only choose between hexagonal and rhombohedral axes.
  const double alpha = exact_decimal(crystal.cell[3], "cell parameter alpha").to_double();
  const double gamma = exact_decimal(crystal.cell[5], "cell parameter gamma").to_double();
  const gemmi::SpaceGroup* meant = gemmi::find_spacegroup_by_name(symbol, alpha, gamma);
  if (meant == nullptr) return {};
  std::vector<GroupSetting> list = {{meant->xhm(), operations_of_setting(*meant)}};
  if (without_spaces(symbol) == without_spaces(meant->hm)) return list;
  for (const gemmi::SpaceGroup& other : gemmi::spacegroup_tables::main)
    if (other.number == meant->number && &other != meant)
      list.push_back({other.xhm(), operations_of_setting(other)});
  return list;
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
std::optional<Isometry> file_matrix(const cif::Block& block) {
  Isometry map{Matrix(3), Vector(3)};
  const std::string prefix = "_atom_sites.fract_transf_";
  for (int i = 0; i < 3; ++i) {
    const std::string row = "[" + std::to_string(i + 1) + "]";
    for (int j = 0; j < 3; ++j) {
      const std::string tag = prefix + "matrix" + row + "[" + std::to_string(j + 1) + "]";
      const std::string value = value_of(block, {tag.c_str()});
      if (value.empty()) return std::nullopt;
      map.linear(i, j) = exact_decimal(value, tag);
    }
    const std::string tag = prefix + "vector" + row;
    const std::string value = value_of(block, {tag.c_str()});
    map.translation[i] = value.empty() ? Rational() : exact_decimal(value, tag);
  }
  return map;
}

/// Reads the positions; sites whose coordinates are '?' or '.' (calculated or unobserved) are left out.
bool read_position(const cif::Table::Row& row, int column, const std::string& label, Vector& position) {
  for (int i = 0; i < 3; ++i)
    if (cif::is_null(row[column + i])) return false;
  for (int i = 0; i < 3; ++i)
    position[i] = exact_decimal(cif::as_string(row[column + i]), "coordinate of site " + label);
  return true;
}

void read_small_molecule_sites(cif::Block& block, Crystal& crystal) {
  cif::Table table = block.find(
      "_atom_site_", {"label", "fract_x", "fract_y", "fract_z", "?disorder_group", "?disorder_assembly"});
  std::size_t without_position = 0;
  for (const cif::Table::Row& row : table) {
    CrystalSite site;
    site.label = cif::as_string(row[0]);
    if (!read_position(row, 1, site.label, site.position)) {
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

void read_macromolecule_sites(cif::Block& block, Crystal& crystal) {
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
    CrystalSite site;
    site.alternative = text(kAlternative);
    const std::string chain = row.has2(kAuthAsym) ? text(kAuthAsym) : text(kLabelAsym);
    const std::string number = (row.has2(kAuthSeq) ? text(kAuthSeq) : text(kLabelSeq)) + text(kInsertion);
    site.group = text(kLabelAsym) + "/" + chain + "/" + number;
    site.label = text(kAtom) + (site.alternative.empty() ? "" : ".") + site.alternative + " " +
                 text(kResidue) + " " + chain + number;
    if (!read_position(row, kX, site.label, site.position))
      throw InvalidInput("site " + site.label + " has no coordinates");
    crystal.sites.push_back(site);
  }
  if (later_atoms > 0)
    crystal.notes.push_back("only the first model is used: " + std::to_string(later_atoms) +
                            " atoms of later ones are left out");
}

Crystal read_cif(const std::string& text, const std::string& file) {
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
    Crystal crystal;
    const std::array<const char*, 6> names = {"length_a",    "length_b",   "length_c",
                                              "angle_alpha", "angle_beta", "angle_gamma"};
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string with_underscore = std::string("_cell_") + names[i];
      const std::string with_point = std::string("_cell.") + names[i];
      crystal.cell[i] = value_of(block, {with_underscore.c_str(), with_point.c_str()});
      if (crystal.cell[i].empty())
        throw InvalidInput("no unit cell: data block " + block.name + " has no " + with_underscore);
      const std::string& value = crystal.cell[i];
      exact_decimal(value, with_underscore);
      if (value.back() == ')') crystal.cell[i] = value.substr(0, value.find('('));
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
      crystal.fractional_from_cartesian = file_matrix(block);
    }
    return crystal;
  }
  throw InvalidInput("the CIF file has no atom sites");
}

}  // namespace

Crystal read_crystal(const std::string& bytes, const std::string& file) {
  const std::string text = unpacked(bytes);
  Crystal crystal = is_cif(text) ? read_cif(text, file) : read_pdb(text, file);
  if (!crystal.symbol.empty()) crystal.settings = settings_of_symbol(crystal);
  return crystal;
}

}  // namespace flatdt::ref::cli
