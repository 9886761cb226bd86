#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "flatdt/ref/errors.hpp"
#include "scene_text.hpp"
#include "viewer_page.hpp"

namespace flatdt::ref {
namespace {

constexpr int kDigits = 7;  // what single precision, that of WebGL, holds
constexpr std::size_t kMaxPageCells = 60'000;
constexpr std::array<const char*, 5> kKinds = {"cell", "other-cell", "face", "other-face", "point"};

/// A JSON array of the items as `text` writes them.
template <typename Items, typename Text>
std::string array_of(const Items& items, const Text& text) {
  std::string result = "[";
  for (const auto& item : items) result += (result.size() > 1 ? "," : "") + text(item);
  return result + "]";
}

std::string place_json(const Place3& p) {
  return "[" + decimal_text(p[0], kDigits) + "," + decimal_text(p[1], kDigits) + "," +
         decimal_text(p[2], kDigits) + "]";
}

template <typename Places>
std::string places_json(const Places& places) {
  return array_of(places, place_json);
}

std::string scene_json(const Scene& scene, int copies) {
  std::vector<std::uint32_t> violated;
  for (std::size_t c = 0; c < scene.is_violated.size(); ++c)
    if (scene.is_violated[c]) violated.push_back(static_cast<std::uint32_t>(c));
  const auto number = [](std::uint32_t n) { return std::to_string(n); };
  std::string text = "{\"title\":" + json_string(scene.title);
  text += ",\n\"notes\":" + array_of(scene.notes, [](const std::string& s) { return json_string(s); });
  text += ",\n\"lattice\":" + places_json(scene.lattice);
  text += ",\n\"fullLattice\":" + (scene.full_lattice ? places_json(*scene.full_lattice) : "null");
  text += ",\n\"hasCopies\":" + std::string(scene.has_copies ? "true" : "false");
  text += ",\n\"copies\":" + std::to_string(copies);
  text += ",\n\"places\":" + places_json(scene.places);
  text += ",\n\"pointAt\":" + array_of(scene.point_at, number);
  text += ",\n\"cells\":" + array_of(scene.cells, [&](const Scene::Cell& cell) {
            return "[" + number(cell.corners[0]) + "," + number(cell.corners[1]) + "," +
                   number(cell.corners[2]) + "," + number(cell.corners[3]) + "," + number(cell.index) + "," +
                   number(cell.image) + "]";
          });
  text += ",\n\"violated\":" + array_of(violated, number);
  text += ",\n\"figures\":" + array_of(scene.figures, [](const Scene::Figure& figure) {
            return std::string("{\"kind\":\"") + kKinds.at(static_cast<std::size_t>(figure.kind)) +
                   "\",\"corners\":" + places_json(figure.corners) + "}";
          });
  text += ",\n\"sphere\":" + (scene.sphere
                                  ? "{\"centre\":" + place_json(scene.sphere->centre) +
                                        ",\"radius\":" + decimal_text(scene.sphere->radius, kDigits) + "}"
                                  : std::string("null"));
  return text + "}";
}

/// WebGL computes in single precision, and the page squares lengths: a cell far from 1 is drawn at a scale of
/// its own, with a note.
Scene within_single_precision(Scene scene) {
  constexpr int kMaxExponent = 20;
  const int exponent = std::ilogb(scene.lattice[0][0]);  // the shortest vector of a reduced basis
  if (std::abs(exponent) <= kMaxExponent) return scene;
  const auto shrink = [exponent](Place3& p) {
    for (double& x : p) x = std::ldexp(x, -exponent);
  };
  std::for_each(scene.lattice.begin(), scene.lattice.end(), shrink);
  if (scene.full_lattice) std::for_each(scene.full_lattice->begin(), scene.full_lattice->end(), shrink);
  std::for_each(scene.places.begin(), scene.places.end(), shrink);
  for (Scene::Figure& figure : scene.figures)
    std::for_each(figure.corners.begin(), figure.corners.end(), shrink);
  if (scene.sphere) {
    shrink(scene.sphere->centre);
    scene.sphere->radius = std::ldexp(scene.sphere->radius, -exponent);
  }
  scene.notes.push_back("Lengths are divided by 2^" + std::to_string(exponent) + ".");
  return scene;
}

}  // namespace

std::string html_text(const Scene& scene, int copies) {
  if (scene.dimension != 3) throw InvalidInput("HTML pages are for dimension 3: draw this one as .svg");
  if (scene.cells.size() > kMaxPageCells)
    throw LimitReached("more than " + std::to_string(kMaxPageCells) +
                       " cells with their images in an HTML page: draw them as .vtu");
  std::string page = kViewerPage;
  constexpr std::string_view kPlace = "@DATA@";
  const std::size_t at = page.find(kPlace);
  ensure(at != std::string::npos, "the page has a place for the data");
  return page.replace(at, kPlace.size(), scene_json(within_single_precision(scene), copies));
}

}  // namespace flatdt::ref
