#include "svg_text.hpp"

#include <algorithm>
#include <cmath>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::picture {

const char* const kSvgStyle =
    "<style>\n"
    ".paper{fill:#fdfdfb;stroke:#c3cad1}\n"
    ".cell{fill:#d6e4f2;stroke:#2b5a88;stroke-width:1.5;stroke-linejoin:round}\n"
    ".named{fill:#f6d5cf}\n"
    ".copies .cell{fill:#f1f5f9;stroke:#a9bccf;stroke-width:1}\n"
    ".copies .turned{fill:#f8f1e6;stroke:#cdb795}\n"
    ".copies .named{fill:#f9e7e3}\n"
    ".domain{fill:none;stroke:#8a4b08;stroke-width:2.2;stroke-dasharray:9 5}\n"
    ".lattice{fill:none;stroke:#8a4b08;stroke-width:1.2;stroke-dasharray:2 4}\n"
    ".arrow{fill:#8a4b08}\n"
    ".point{fill:#16202b}\n"
    ".copies .point{fill:#8b99a8}\n"
    ".label,.caption,.title{fill:#16202b;font-family:system-ui,Helvetica,Arial,sans-serif}\n"
    ".title{font-weight:600}\n"
    ".label{stroke:#fdfdfb;stroke-width:3;paint-order:stroke;stroke-linejoin:round}\n"
    ".copies .label{fill:#8b99a8}\n"
    ".disk{fill:#b3261e;fill-opacity:.08;stroke:#b3261e;stroke-width:2;stroke-dasharray:12 4 2 4}\n"
    ".mark-cell{fill:url(#hatch);stroke:#b3261e;stroke-width:3.5;stroke-linejoin:round}\n"
    ".mark-other-cell{fill:url(#dots);stroke:#b3261e;stroke-width:2.5;stroke-dasharray:7 4;"
    "stroke-linejoin:round}\n"
    ".mark-face{fill:none;stroke:#b3261e;stroke-width:6;stroke-linecap:round}\n"
    ".mark-other-face{fill:none;stroke:#b3261e;stroke-width:6;stroke-dasharray:13 8}\n"
    ".mark-point{fill:none;stroke:#b3261e;stroke-width:2.5}\n"
    ".hatch{stroke:#b3261e;stroke-width:1.6}\n"
    ".dot{fill:#b3261e}\n"
    "@media (prefers-color-scheme:dark){\n"
    ".paper{fill:#12171d;stroke:#3b4651}\n"
    ".cell{fill:#1f3a54;stroke:#8fc1ee}\n"
    ".named{fill:#5a2a27}\n"
    ".copies .cell{fill:#182029;stroke:#48596b}\n"
    ".copies .turned{fill:#221e17;stroke:#6b5a3e}\n"
    ".copies .named{fill:#3a2321}\n"
    ".domain,.lattice{stroke:#f2b36b}\n"
    ".arrow{fill:#f2b36b}\n"
    ".point,.label,.caption,.title{fill:#eef3f8}\n"
    ".label{stroke:#12171d}\n"
    ".copies .point,.copies .label{fill:#7d8b99}\n"
    ".disk{fill:#ff8a80;stroke:#ff8a80}\n"
    ".mark-cell,.mark-other-cell,.mark-face,.mark-other-face,.mark-point,.hatch{stroke:#ff8a80}\n"
    ".dot{fill:#ff8a80}\n"
    "}\n"
    "</style>\n"
    "<defs>\n"
    "<pattern id=\"hatch\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\" "
    "patternTransform=\"rotate(45)\"><path class=\"hatch\" d=\"M0 0L0 8\"/></pattern>\n"
    "<pattern id=\"dots\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\">"
    "<circle class=\"dot\" cx=\"3\" cy=\"3\" r=\"1.2\"/></pattern>\n"
    "</defs>\n";

std::string number_text(double value) {
  if (!(std::abs(value) < 1e9)) throw LimitReached("the cell is too large, small or long to be drawn");
  const long long hundredths = std::llround(value * 100);
  const long long size = hundredths < 0 ? -hundredths : hundredths;
  const std::string fraction = std::to_string(size % 100);
  return (hundredths < 0 ? "-" : "") + std::to_string(size / 100) + (size % 100 == 0 ? "" : ".") +
         (size % 100 == 0 ? "" : (fraction.size() == 1 ? "0" : "") + fraction);
}

bool is_drawable(const std::vector<Place>& places) {
  constexpr double kFar = 1e7;  // page units
  return std::all_of(places.begin(), places.end(),
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
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string path(const std::vector<Place>& places, bool closed, const std::string& css_class) {
  std::string d;
  for (const Place& p : places) d += (d.empty() ? "M" : "L") + number_text(p.x) + " " + number_text(p.y);
  return "<path class=\"" + css_class + "\" d=\"" + d + (closed ? "Z" : "") + "\"/>\n";
}

std::string circle(const Place& p, double radius, const std::string& css_class) {
  return "<circle class=\"" + css_class + "\" cx=\"" + number_text(p.x) + "\" cy=\"" + number_text(p.y) +
         "\" r=\"" + number_text(radius) + "\"/>\n";
}

std::string line_of_text(const Place& p, double size, const std::string& css_class,
                         const std::string& plain) {
  return "<text class=\"" + css_class + "\" x=\"" + number_text(p.x) + "\" y=\"" + number_text(p.y) +
         "\" font-size=\"" + number_text(size) + "\">" + escaped(plain) + "</text>\n";
}

std::vector<std::string> wrapped(const std::string& plain, std::size_t width, std::size_t most) {
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < plain.size()) {
    const std::size_t end = std::min(plain.find(' ', at), plain.size());
    const std::string word = plain.substr(at, end - at);
    at = std::min(end + 1, plain.size());
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) {
      if (lines.size() == most) {
        lines.back() += " ...";
        return lines;
      }
      lines.emplace_back();
    }
    lines.back() += (lines.back().empty() ? "" : " ") + word.substr(0, std::max<std::size_t>(width, 4));
  }
  return lines;
}

}  // namespace flatdt::ref::picture
