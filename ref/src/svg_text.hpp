/// Shapes and text of an SVG document. Numbers have two decimals and do not follow the locale.
#pragma once

#include <string>
#include <vector>

namespace flatdt::ref::picture {

/// On the page: x to the right, y down.
struct Place {
  double x, y;
};

/// Two decimals. Throws LimitReached unless |value| < 1e9: a metric whose entries exceed the range of double
/// gives infinities and NaNs.
std::string number_text(double value);
/// Places of hostile triangulations may be infinite or not a number: those cannot be shown.
bool is_drawable(const std::vector<Place>& places);
/// Text between tags or in an attribute.
std::string escaped(const std::string& plain);
std::string path(const std::vector<Place>& places, bool closed, const std::string& css_class);
std::string circle(const Place& p, double radius, const std::string& css_class);
std::string line_of_text(const Place& p, double size, const std::string& css_class, const std::string& plain);
/// The words in lines of at most `width` characters (one longer word is a line); at most `most` lines, the
/// last then ends with an ellipsis.
std::vector<std::string> wrapped(const std::string& plain, std::size_t width, std::size_t most);

/// The style sheet, and the hatchings that it refers to: every meaning has a line style or a hatching of its
/// own besides its colour. Own paper, so that the picture can be read on any background; it follows the
/// viewer's colour scheme, which is a light one in print.
extern const char* const kSvgStyle;

}  // namespace flatdt::ref::picture
