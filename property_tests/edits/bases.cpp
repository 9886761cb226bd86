#include "bases.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "flatdt/ref/families.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"
#include "respace.hpp"

namespace flatdt::edits {

namespace {

using Form = Recipe::Form;

/// Covering spaces of many points: 120 points of a dicosm and 54 sheets are 45,000 cells, too many to edit
/// and check hundreds of times.
constexpr std::size_t kMostCells = 1600;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return text.str();
}

/// Families in turn: every one comes to every manifold and form after some rounds.
const std::string& family(std::size_t k) {
  const std::vector<ref::Family>& all = ref::families();
  return all[k % all.size()].name;
}

}  // namespace

std::vector<Recipe> recipes(bool quick, std::size_t round, std::uint64_t seed) {
  std::vector<Recipe> all;
  std::size_t m = 0;
  for (const ref::CatalogueEntry& entry : ref::catalogue()) {
    const bool planar = entry.dimension == 2;
    const auto add = [&](const std::string& of, long points, const std::string& metric, Form form) {
      all.push_back({entry.name, of, points, metric, 1000 * seed + 97 * round + all.size(), form});
    };
    const std::size_t turn = 5 * round + 3 * m;
    if (planar) {
      add("uniform", 20, "canonical", Form::as_written);
      add("grid", 16, "canonical", Form::as_written);
      add(family(turn), 3, "random", quick ? Form::small_cover : Form::as_written);
      if (!quick) add("near-cospherical", 24, "canonical", Form::as_written);
      add(family(turn + 1), 4, "canonical", Form::small_cover);
    } else if (quick) {
      if (m % 2 == 0)
        add(m % 4 == 0 ? "uniform" : "grid", 1, "canonical", Form::small_manifold);
      else
        add(m % 4 == 1 ? "grid" : "near-cospherical", 1, "canonical", Form::small_cover);
    } else {
      add("uniform", 1, "random", Form::as_written);
      add("grid", 1, "canonical", Form::small_manifold);
      add("grid", 2, "canonical", Form::small_cover);
      add("near-cospherical", 3, "canonical", Form::small_cover);
      add(family(turn), 2, "random", Form::small_manifold);
      add(family(turn + 2), 3, "canonical", Form::small_cover);
      if (entry.holonomy_order <= 2) {
        add("uniform", 120, "canonical", Form::as_written);
        add(family(turn + 4), 120, "canonical", Form::as_written);
      }
    }
    ++m;
  }
  return all;
}

std::optional<Base> make_base(const Recipe& recipe) {
  const ref::CatalogueEntry* entry = ref::find_entry(recipe.manifold);
  if (entry == nullptr) throw std::runtime_error("no manifold is called " + recipe.manifold);
  std::string label = recipe.manifold + " " + recipe.family + " " + std::to_string(recipe.points) + " " +
                      recipe.metric + " seed " + std::to_string(recipe.seed);
  Case made;
  made.instance =
      ref::generate(*entry, recipe.manifold, recipe.family, recipe.points, recipe.seed, recipe.metric);
  made.triangulation = ref::triangulate(made.instance, ref::analyse(made.instance), {}).triangulation;
  if (recipe.form == Form::as_written) {
    if (made.triangulation.cells.size() > kMostCells) return std::nullopt;
    return Base(std::move(made), std::move(label));
  }
  Random random(recipe.seed, label);
  std::optional<Case> small = over_small_subgroup(made, random);
  if (!small) return std::nullopt;
  if (recipe.form == Form::small_cover) return Base(std::move(*small), label + " over a small subgroup");
  if (recipe.family == "single-orbit") return std::nullopt;
  return Base(as_manifold(*small), label + " as a manifold");
}

std::vector<Base> bases_of_folder(const std::string& folder, std::size_t most_cells) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".triangulation") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Base> bases;
  for (std::filesystem::path path : paths) {
    Case c;
    const std::string text = text_of(path);
    path.replace_extension(".instance");
    c.instance = ref::parse_instance(text_of(path), path.string());
    c.triangulation =
        ref::parse_triangulation(text, path.string(), c.instance.dimension, c.instance.points.size());
    if (c.triangulation.cells.size() <= most_cells) bases.emplace_back(std::move(c), path.stem().string());
  }
  return bases;
}

}  // namespace flatdt::edits
