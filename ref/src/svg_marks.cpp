#include <algorithm>
#include <cmath>

#include "svg_internal.hpp"

namespace flatdt::ref::picture {
namespace {

constexpr double kLine = 21, kText = 14.5, kSide = 14, kSample = 40;  // page units

struct Style {
  Mark::Kind kind;
  const char* css_class;
  const char* meaning;
};
/// In the order of drawing.
constexpr std::array<Style, 5> kStyles = {{{Mark::Kind::other_cell, "mark-other-cell", "cell beside it"},
                                           {Mark::Kind::cell, "mark-cell", "cell"},
                                           {Mark::Kind::other_face, "mark-other-face", "other edge"},
                                           {Mark::Kind::face, "mark-face", "edge"},
                                           {Mark::Kind::point, "mark-point", "vertex"}}};

std::string ring(const Place& p) {
  return path({{p.x - 14, p.y}, {p.x + 14, p.y}}, false, "mark-point") +
         path({{p.x, p.y - 14}, {p.x, p.y + 14}}, false, "mark-point") + circle(p, 8, "mark-point");
}

std::string shape(const Style& style, const std::vector<Place>& places) {
  if (places.size() == 1) return ring(places[0]);
  return path(places, places.size() > 2, style.css_class);
}

/// A small picture of the style, its meaning, and where the next begins.
std::string sample(const Style& style, const std::string& meaning, Place& at) {
  const double middle = at.y - 5;
  std::vector<Place> places;
  if (style.kind == Mark::Kind::cell || style.kind == Mark::Kind::other_cell)
    places = {{at.x, middle + 8}, {at.x + kSample, middle + 8}, {at.x + kSample / 2, middle - 12}};
  else if (style.kind == Mark::Kind::point)
    places = {{at.x + kSample / 2, middle}};
  else
    places = {{at.x + 2, middle}, {at.x + kSample - 2, middle}};
  std::string text =
      shape(style, places) + line_of_text({at.x + kSample + 8, at.y}, kText, "caption", meaning);
  at.x += kSample + 8 + 7.4 * static_cast<double>(meaning.size()) + 18;
  return text;
}

}  // namespace

std::string marks_text(const Witness& witness, const PictureGroup& group, const Domain& domain,
                       const Page& page, std::vector<std::string>& notes) {
  if (witness.marks.empty()) return {};
  const Isometry move = domain.into(group, barycentre(witness.marks.front().corners));
  std::string text;
  bool is_complete = true;
  if (witness.ball) {
    const Place centre = page.place(move * witness.ball->centre);
    const double radius = std::sqrt(witness.ball->radius_squared.to_double()) * page.scale();
    if (is_drawable({centre, {radius, radius}}))
      text += circle(centre, radius, "disk");
    else
      is_complete = false;
  }
  for (const Style& style : kStyles) {
    for (const Mark& mark : witness.marks) {
      if (mark.kind != style.kind) continue;
      std::vector<Place> places;
      for (const Vector& x : mark.corners) places.push_back(page.place(move * x));
      if (is_drawable(places))
        text += shape(style, places);
      else
        is_complete = false;
    }
  }
  if (!is_complete) notes.emplace_back("A part of the witness is too far away or too large to be drawn.");
  return text;
}

Caption caption_text(const std::string& title, const std::vector<std::string>& sentences,
                     const Witness* witness, double width, double top) {
  Caption caption{"", 0, std::max(width, 420.0)};
  const auto characters = static_cast<std::size_t>((caption.width - 2 * kSide) / 7.4);
  double y = top + kLine + 3;
  for (const std::string& line : wrapped(title, characters, 2)) {
    caption.text += line_of_text({kSide, y}, kText + 2, "title", line);
    y += kLine;
  }
  for (const std::string& sentence : sentences) {
    for (const std::string& line : wrapped(sentence, characters, 3)) {
      caption.text += line_of_text({kSide, y}, kText, "caption", line);
      y += kLine;
    }
  }
  if (witness != nullptr && !witness->marks.empty()) {
    y += 8;
    Place at{kSide, y};
    const auto add = [&](const Style& style, const std::string& meaning) {
      if (at.x > kSide && at.x + kSample + 8 * static_cast<double>(meaning.size()) > caption.width - kSide)
        at = {kSide, at.y + kLine + 4};
      caption.text += sample(style, meaning, at);
    };
    // The main figure first.
    for (const std::size_t k : {1U, 0U, 3U, 2U, 4U}) {
      const Style& style = kStyles[k];
      const auto has_kind = [&](const Mark& m) { return m.kind == style.kind; };
      const bool occurs = std::any_of(witness->marks.begin(), witness->marks.end(), has_kind);
      const bool is_inside = style.kind == Mark::Kind::point && witness->ball;
      if (occurs) add(style, is_inside ? "vertex inside the disk" : style.meaning);
    }
    y = at.y + kLine;
  }
  caption.height = y - top - 4;
  return caption;
}

}  // namespace flatdt::ref::picture
