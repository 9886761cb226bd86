#include "flatdt/ref/svg.hpp"

#include <algorithm>
#include <cmath>

#include "flatdt/ref/errors.hpp"
#include "svg_internal.hpp"

namespace flatdt::ref {
namespace {

using namespace svg_detail;

constexpr double kCaptionHeight = 34;
constexpr std::size_t kMaxLabels = 1500;
constexpr double kFar = 1e7;  // page units
constexpr const char* kTooFar = "What was found is too far away to be drawn.";

/// The picture has its own paper, so it can be read on any background; it follows the viewer's colour scheme.
constexpr const char* kStyle =
    "<style>\n"
    ".paper{fill:#fdfdfb;stroke:#9aa5b1}\n"
    ".cell{fill:#dbe7f3;stroke:#2f5d8a;stroke-width:1.4;stroke-linejoin:round}\n"
    ".copies{opacity:.3}\n"
    ".domain{fill:none;stroke:#8a4b08;stroke-width:2;stroke-dasharray:7 4}\n"
    ".lattice{fill:none;stroke:#8a4b08;stroke-width:1.2;stroke-dasharray:2 4}\n"
    ".point{fill:#1c2733}\n"
    ".label,.caption{fill:#1c2733;font-family:sans-serif}\n"
    ".label{stroke:#fdfdfb;stroke-width:3;paint-order:stroke}\n"
    ".cycle{fill:none;stroke:#b3261e;stroke-width:5;stroke-linecap:round;stroke-linejoin:round}\n"
    ".disk{fill:#b3261e;fill-opacity:.12;stroke:#b3261e;stroke-width:2.5}\n"
    ".inside{fill:#b3261e}\n"
    "@media (prefers-color-scheme:dark){\n"
    ".paper{fill:#161b21;stroke:#5b6773}\n"
    ".cell{fill:#22384d;stroke:#8fbce6}\n"
    ".domain,.lattice{stroke:#f0a95b}\n"
    ".point,.label,.caption{fill:#eef2f6}\n"
    ".label{stroke:#161b21}\n"
    ".cycle,.disk{stroke:#ff8a80}\n"
    ".disk,.inside{fill:#ff8a80}\n"
    "}\n"
    "</style>\n";

/// Two decimals; printf would follow the locale. Throws LimitReached unless |value| < 1e9 (a metric whose
/// entries exceed the range of double gives infinities and NaNs here).
std::string text(double value) {
  if (!(std::abs(value) < 1e9)) throw LimitReached("the cell is too large, small or long to be drawn");
  const long long hundredths = std::llround(value * 100);
  const long long size = hundredths < 0 ? -hundredths : hundredths;
  const std::string fraction = std::to_string(size % 100);
  return (hundredths < 0 ? "-" : "") + std::to_string(size / 100) + (size % 100 == 0 ? "" : ".") +
         (size % 100 == 0 ? "" : (fraction.size() == 1 ? "0" : "") + fraction);
}

/// Places of hostile triangulations may be infinite or not a number: those cannot be shown.
template <typename Places>
bool is_drawable(const Places& places) {
  return std::all_of(std::begin(places), std::end(places),
                     [](const Place& p) { return std::abs(p.x) < kFar && std::abs(p.y) < kFar; });
}

std::string escaped(const std::string& plain) {
  std::string result;
  for (const char c : plain) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

template <typename Places>
std::string path(const Places& places, bool closed, const char* css_class) {
  std::string d;
  for (const Place& p : places) d += (d.empty() ? "M" : "L") + text(p.x) + " " + text(p.y);
  return std::string("<path class=\"") + css_class + "\" d=\"" + d + (closed ? "Z" : "") + "\"/>\n";
}

std::string circle(const Place& p, double radius, const char* css_class) {
  return std::string("<circle class=\"") + css_class + "\" cx=\"" + text(p.x) + "\" cy=\"" + text(p.y) +
         "\" r=\"" + text(radius) + "\"/>\n";
}

/// The group whose copies are drawn: that of the cover, or of the surface.
struct Shown {
  PlaneGroup group;
  bool has_copies = true;
};

Shown shown_group(const Instance& instance, const Triangulation& triangulation, const PlaneGroup& full,
                  std::vector<std::string>& notes) {
  if (!triangulation.has_subgroup) return {full};
  Instance cover = instance;
  cover.name.reset();
  cover.generators = triangulation.subgroup;
  cover.generators_given = true;
  try {
    return {PlaneGroup(analyse(cover))};
  } catch (const InvalidInput& error) {
    notes.push_back("The subgroup is not admissible, so only the listed cells are drawn: " +
                    std::string(error.what()) + ".");
    return {full, false};
  }
}

std::string cells_text(const std::vector<Triangle>& triangles, const Shown& shown, const Page& page,
                       std::vector<std::string>& notes) {
  PlaneGroup group = shown.group;
  if (!shown.has_copies) group.cosets = {Isometry::identity(2)};
  std::string inside, around;
  std::size_t drawn = 0, too_large = 0;
  for (const Triangle& t : triangles) {
    const std::vector<DrawnTriangle> list = copies(t, group, page);
    if (list.empty()) ++too_large;
    drawn += list.size();
    if (drawn > kMaxDrawnCells)
      throw LimitReached("more than " + std::to_string(kMaxDrawnCells) +
                         " triangles in view: too many to draw");
    for (const DrawnTriangle& copy : list) {
      if (!copy.in_cell && !shown.has_copies) continue;
      (copy.in_cell ? inside : around) += path(copy.corners, true, "cell");
    }
  }
  if (too_large > 0) notes.push_back(std::to_string(too_large) + " cells are too large to be drawn.");
  return "<g class=\"copies\">\n" + around + "</g>\n<g class=\"cells\">\n" + inside + "</g>\n";
}

std::string points_text(const std::vector<DrawnPoint>& points, const Page& page) {
  // A quarter of the typical distance of points, within what can be read.
  const double area = page.width() * page.height() / static_cast<double>(points.size() + 1);
  const double size = std::clamp(std::sqrt(area) / 4, 7.0, 18.0);
  std::string inside, around;
  for (const DrawnPoint& p : points) {
    std::string& target = p.in_cell ? inside : around;
    target += circle(p.place, size / 5 + 1, "point");
    if (points.size() <= kMaxLabels)
      target += "<text class=\"label\" x=\"" + text(p.place.x + size / 3) + "\" y=\"" +
                text(p.place.y - size / 3) + "\" font-size=\"" + text(size) + "\">" +
                std::to_string(p.index) + "</text>\n";
  }
  return "<g class=\"copies\">\n" + around + "</g>\n<g class=\"points\">\n" + inside + "</g>\n";
}

std::string cell_outline(const Page& page, const Matrix& basis, const char* css_class) {
  const Vector zero(2), a = basis.column(0), b = basis.column(1);
  const std::array<Place, 4> corners = {page.place(zero), page.place(a), page.place(a + b), page.place(b)};
  return path(corners, true, css_class);
}

std::string cycle_text(const std::vector<Triangle>& triangles, const Shown& shown, const PlaneGroup& full,
                       const Page& page, std::vector<std::string>& notes) {
  const std::optional<Cycle> cycle = find_cycle(triangles, full);
  if (!cycle) {
    notes.emplace_back("The quotient by the group has neither a loop nor a 2-cycle.");
    return {};
  }
  const Vector shift = shift_into_cell(shown.group, cycle->middle);
  std::vector<Place> places = {page.place(cycle->end + shift), page.place(cycle->middle + shift)};
  if (!cycle->loop) places.push_back(page.place(cycle->other_end + shift));
  notes.push_back(cycle->loop ? "Loop: the ends (" + cycle->middle.to_string() + ") and (" +
                                    cycle->end.to_string() + ") of an edge are one vertex of the quotient."
                              : "2-cycle: the edges from (" + cycle->middle.to_string() + ") to (" +
                                    cycle->end.to_string() + ") and to (" + cycle->other_end.to_string() +
                                    ") have the same ends in the quotient.");
  if (is_drawable(places)) return path(places, false, "cycle");
  notes.emplace_back(kTooFar);
  return {};
}

std::string violation_text(const Instance& instance, const std::vector<Triangle>& triangles,
                           const Shown& shown, const PlaneGroup& full, const Page& page,
                           std::vector<std::string>& notes) {
  const std::optional<Violation> found = find_violation(instance, triangles, full);
  if (!found) {
    notes.emplace_back("No circumdisk has a point strictly inside.");
    return {};
  }
  const Vector shift = shift_into_cell(shown.group, found->centre);
  const double radius = std::sqrt(found->radius_squared.to_double()) * page.scale();
  notes.push_back("Violation: the circumdisk of cell " + std::to_string(found->cell) + " has point " +
                  std::to_string(found->point) + " inside, at (" + found->inside.to_string() +
                  "): squared distance from the centre " + found->distance_squared.to_string() +
                  " < squared radius " + found->radius_squared.to_string() + ".");
  std::array<Place, 5> places{page.place(found->centre + shift), page.place(found->inside + shift)};
  for (std::size_t k = 0; k < 3; ++k) places[2 + k] = page.place(triangles[found->cell][k] + shift);
  if (!is_drawable(places) || !(radius < kFar)) {
    notes.emplace_back(kTooFar);
    return {};
  }
  const std::array<Place, 3> corners = {places[2], places[3], places[4]};
  return circle(places[0], radius, "disk") + path(corners, true, "cycle") + circle(places[1], 8, "inside");
}

}  // namespace

Drawing draw_svg(const Instance& instance, const Triangulation& triangulation,
                 const DrawingOptions& options) {
  if (instance.dimension != 2 || triangulation.dimension != 2)
    throw InvalidInput("draw is for dimension 2; the instance has dimension " +
                       std::to_string(instance.dimension));
  Drawing drawing;
  const GroupAnalysis analysis = analyse(instance);
  const PlaneGroup full(analysis);
  const Shown shown = shown_group(instance, triangulation, full, drawing.notes);
  const Page page(shown.group);
  const std::vector<Triangle> triangles = triangles_of(instance, triangulation);

  std::string body = cells_text(triangles, shown, page, drawing.notes);
  body += cell_outline(page, shown.group.basis, "domain");
  if (triangulation.has_subgroup) body += cell_outline(page, full.basis, "lattice");
  const std::string points = points_text(point_copies(instance, full, shown.group, page), page);
  std::string witnesses;
  if (options.show_violation)
    witnesses += violation_text(instance, triangles, shown, full, page, drawing.notes);
  if (options.show_two_cycle) witnesses += cycle_text(triangles, shown, full, page, drawing.notes);

  const std::string title = "Triangulation of " +
                            std::string(triangulation.has_subgroup ? "a covering space of the " : "the ") +
                            analysis.entry->name;
  std::string description = std::to_string(instance.points.size()) + " points, " +
                            std::to_string(triangles.size()) +
                            " cells. Dashed: a cell of the reduced translation lattice; faded: copies.";
  for (const std::string& note : drawing.notes) description += " " + note;
  const std::string width = text(page.width()), height = text(page.height());
  const std::string total = text(page.height() + kCaptionHeight);
  drawing.svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
      width + "\" height=\"" + total + "\" viewBox=\"0 0 " + width + " " + total +
      "\" role=\"img\" aria-labelledby=\"title desc\">\n<title id=\"title\">" + escaped(title) +
      "</title>\n<desc id=\"desc\">" + escaped(description) + "</desc>\n" + kStyle +
      "<clipPath id=\"view\"><rect width=\"" + width + "\" height=\"" + height +
      "\"/></clipPath>\n<rect class=\"paper\" width=\"" + width + "\" height=\"" + total +
      "\" rx=\"8\"/>\n<g clip-path=\"url(#view)\">\n" + body + witnesses + points +
      "</g>\n<text class=\"caption\" x=\"12\" y=\"" + text(page.height() + 22) + "\" font-size=\"15\">" +
      escaped(title) + "</text>\n</svg>\n";
  return drawing;
}

}  // namespace flatdt::ref
