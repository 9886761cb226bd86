/// What a crystal structure file says, as text: the border to gemmi. This header and import_crystal.cpp are
/// C++17, because gemmi 0.5.7 has vectors of incomplete types, which Clang refuses in C++20 with
/// libstdc++ 12.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace flatdt::ref::cli {

struct SiteText {
  std::string label, group, alternative;  // see CrystalSite
  std::array<std::string, 3> position;
};

struct CrystalText {
  std::array<std::string, 6> cell;      // as written
  std::string symbol;                   // empty: none
  std::vector<std::string> operations;  // as listed, "x,y,z"
  bool cartesian = false;
  std::vector<std::string> matrix;  // fractional from Cartesian, [R|t] row by row; empty: none
  std::vector<SiteText> sites;
  std::vector<std::string> notes;
};

/// Operations as [R|t] row by row; t in units of 1/24.
struct SettingText {
  std::string symbol;
  std::vector<std::array<int, 12>> operations;
};

/// The text itself, unpacked if it is gzip'ed. Errors: InvalidInput if it is damaged, LimitReached beyond
/// 64 MB (a few kilobytes can unpack to gigabytes).
std::string unpacked(const std::string& bytes);

/// The first data block with atom sites. Errors: InvalidInput.
CrystalText read_cif(const std::string& text, const std::string& file);

/// See Crystal::settings. The angles choose between hexagonal and rhombohedral axes only.
std::vector<SettingText> settings_of_symbol(const std::string& symbol, double alpha, double gamma);

}  // namespace flatdt::ref::cli
