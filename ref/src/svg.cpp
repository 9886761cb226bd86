#include "flatdt/ref/svg.hpp"

#include <algorithm>
#include <cmath>

#include "flatdt/ref/errors.hpp"
#include "picture_witness.hpp"
#include "svg_internal.hpp"

namespace flatdt::ref {
namespace {

using namespace picture;

constexpr std::size_t kMaxLabels = 1500;

struct View {
  const Instance& instance;
  const Triangulation& triangulation;
  const ShownGroup& shown;
  const Domain& domain;
  const Page& page;
};

std::string cells_text(const View& view, const std::vector<bool>& is_named, bool show_copies,
                       std::vector<std::string>& notes) {
  PictureGroup group = view.shown.group;
  if (!view.shown.has_copies) group.cosets = {Isometry::identity(2)};
  std::string inside, around;
  std::size_t drawn = 0, too_large = 0;
  for (std::size_t c = 0; c < view.triangulation.cells.size(); ++c) {
    const std::vector<DrawnTriangle> list =
        copies(simplex_of(view.instance, view.triangulation, c), group, view.domain, view.page);
    if (list.empty()) ++too_large;
    drawn += list.size();
    if (drawn > kMaxDrawnCells)
      throw LimitReached("more than " + std::to_string(kMaxDrawnCells) +
                         " triangles in view: too many to draw");
    for (const DrawnTriangle& copy : list) {
      const std::string css_class = std::string("cell") + (is_named[c] ? " named" : "");
      if (copy.in_domain)
        inside += path(copy.corners, true, css_class);
      else if (view.shown.has_copies && show_copies)
        around += path(copy.corners, true, css_class + (copy.turned ? " turned" : ""));
    }
  }
  if (too_large > 0) notes.push_back(std::to_string(too_large) + " cells are too large to be drawn.");
  return "<g class=\"copies\">\n" + around + "</g>\n<g class=\"cells\">\n" + inside + "</g>\n";
}

std::string points_text(const std::vector<DrawnPoint>& points, const Page& page,
                        const std::vector<std::uint32_t>& ringed) {
  // A quarter of the typical distance of points, within what can be read.
  const double area = page.width() * page.height() / static_cast<double>(points.size() + 1);
  const double size = std::clamp(std::sqrt(area) / 4, 7.0, 17.0);
  std::string inside, around;
  for (const DrawnPoint& p : points) {
    std::string& target = p.in_domain ? inside : around;
    target += circle(p.place, size / 5 + 1, "point");
    if (std::find(ringed.begin(), ringed.end(), p.index) != ringed.end())
      target += circle(p.place, size / 2 + 3, "mark-point");
    if (points.size() <= kMaxLabels)
      target +=
          line_of_text({p.place.x + size / 3, p.place.y - size / 3}, size, "label", std::to_string(p.index));
  }
  return "<g class=\"copies\">\n" + around + "</g>\n<g class=\"points\">\n" + inside + "</g>\n";
}

std::string document(const std::string& title, const std::string& description, const std::string& content,
                     const Page& page, const Caption& caption) {
  const std::string width = number_text(page.width()), height = number_text(page.height());
  const std::string total_width = number_text(std::max(page.width(), caption.width));
  const std::string total_height = number_text(page.height() + caption.height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
         total_width + "\" height=\"" + total_height + "\" viewBox=\"0 0 " + total_width + " " +
         total_height + "\" role=\"img\" aria-labelledby=\"title desc\">\n<title id=\"title\">" +
         escaped(title) + "</title>\n<desc id=\"desc\">" + escaped(description) + "</desc>\n" + kSvgStyle +
         "<clipPath id=\"view\"><rect width=\"" + width + "\" height=\"" + height +
         "\"/></clipPath>\n<rect class=\"paper\" x=\"0.5\" y=\"0.5\" width=\"" +
         number_text(std::max(page.width(), caption.width) - 1) + "\" height=\"" +
         number_text(page.height() + caption.height - 1) + "\" rx=\"8\"/>\n<g clip-path=\"url(#view)\">\n" +
         content + "</g>\n" + caption.text + "</svg>\n";
}

}  // namespace

Drawing draw_svg(const Instance& instance, const Triangulation& triangulation,
                 const DrawingOptions& options) {
  if (instance.dimension != 2 || triangulation.dimension != 2)
    throw InvalidInput("SVG is for dimension 2; the instance has dimension " +
                       std::to_string(instance.dimension));
  Drawing drawing;
  const PictureGroup full(analyse(instance));
  const ShownGroup shown = shown_group(instance, triangulation, full, drawing.notes);
  const Domain domain(shown);
  const Page page(shown.group, domain);
  const View view{instance, triangulation, shown, domain, page};

  const std::vector<Witness> witnesses =
      witnesses_of(instance, triangulation,
                   {options.show_violation, options.show_two_cycle, options.verdict, options.condition}, full,
                   shown, drawing.notes);
  Witness all;  // for the samples of line styles
  std::vector<bool> is_named(triangulation.cells.size(), false);
  std::vector<std::uint32_t> ringed;
  std::string marks;
  for (const Witness& witness : witnesses) {
    for (const std::uint32_t c : witness.cells) is_named[c] = true;
    if (witness.point) ringed.push_back(*witness.point);
    marks += marks_text(witness, shown.group, domain, page, drawing.notes);
    all.marks.insert(all.marks.end(), witness.marks.begin(), witness.marks.end());
    if (witness.ball) all.ball = witness.ball;
  }
  std::string content = cells_text(view, is_named, options.show_copies, drawing.notes);
  content += domain_text(domain, page);
  if (triangulation.has_subgroup) content += lattice_cell_text(full, page);
  content += "<g class=\"witness\">\n" + marks + "</g>\n";
  content += points_text(point_copies(instance, full, shown.group, domain, page), page, ringed);

  const std::string title = title_of(triangulation, full);
  std::string description = "Points: " + std::to_string(instance.points.size()) +
                            ", cells: " + std::to_string(triangulation.cells.size()) +
                            ". Dashed: a fundamental domain, sides with the same arrow heads are "
                            "glued; faded: copies.";
  for (const std::string& note : drawing.notes) description += " " + note;
  const Caption caption = caption_text(title, drawing.notes, &all, page.width(), page.height());
  drawing.svg = document(title, description, content, page, caption);
  return drawing;
}

}  // namespace flatdt::ref
