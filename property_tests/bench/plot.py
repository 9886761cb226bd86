"""Line charts as SVG: panels side by side under one legend, readable in print and on dark screens."""
import dataclasses
import math
import typing

WIDTH, HEIGHT = 430, 340          # of one panel, axes included
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 34, 46
LEGEND = 180
HEAD = 30

# Colours of middle lightness, told apart on white and on black, and without colour by dashes and markers.
STYLES = [("#3b82c4", ""), ("#d9722a", ""), ("#2f9e6e", ""), ("#c4569c", ""), ("#8a7be0", ""),
          ("#3b82c4", "6 3"), ("#d9722a", "6 3"), ("#2f9e6e", "6 3"), ("#c4569c", "6 3"), ("#8a7be0", "6 3")]

CSS = """
  svg { background: #ffffff; }
  text { font: 12px sans-serif; fill: #1b1b1b; }
  .title { font-size: 14px; font-weight: bold; }
  .paper { fill: #ffffff; }
  .axis { stroke: #1b1b1b; fill: none; }
  .grid { stroke: #d5d5d5; stroke-width: 0.7; }
  .guide { stroke: #777777; stroke-dasharray: 2 3; fill: none; }
  .note { fill: #666666; font-style: italic; }
  @media screen and (prefers-color-scheme: dark) {
    svg { background: #16181d; }
    text { fill: #e8e8e8; }
    .paper { fill: #16181d; }
    .axis { stroke: #e8e8e8; }
    .grid { stroke: #3a3d44; }
    .note { fill: #aaaaaa; }
  }
"""


@dataclasses.dataclass
class Series:
    name: str
    points: list  # of (x, y), x > 0


@dataclasses.dataclass
class Panel:
    label: str
    series: list
    log_y: bool
    guide: typing.Optional[tuple] = None  # (name, f(x, log)): drawn through the first point of the first series


class Scale:
    """Data to positions along one axis, and the ticks."""

    def __init__(self, values, begin, end, log):
        self.log, self.begin, self.end = log, begin, end
        if log:
            self.low, self.high = math.log10(min(values)), math.log10(max(values))
            margin = 0.04 * max(self.high - self.low, 0.1)
            self.low, self.high = self.low - margin, self.high + margin
        else:
            self.low, self.high = 0, 1.08 * max(values)

    def __call__(self, value):
        at = math.log10(value) if self.log else value
        return self.begin + (self.end - self.begin) * (at - self.low) / (self.high - self.low)

    def ticks(self):
        if self.log:
            for leading in ((1,), (1, 2, 5), range(1, 10)):
                ticks = [m * 10.0**k for k in range(math.floor(self.low), math.floor(self.high) + 1) for m in leading
                         if self.low <= math.log10(m * 10.0**k) <= self.high]
                if len(ticks) >= 3:
                    return ticks
            return ticks or [10.0**self.low, 10.0**self.high]
        step = 10.0**math.floor(math.log10(self.high / 4))
        step *= next(m for m in (1, 2, 5, 10) if self.high / (m * step) <= 6)
        return [k * step for k in range(math.floor(self.high / step) + 1)]


def tick_text(value):
    if value == 0:
        return "0"
    if value >= 1e6:
        return f"{value / 1e6:g}M"
    if value >= 1000:
        return f"{value / 1000:g}k"
    return f"{value:.3g}"


def line(points, attributes):
    return f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}" {attributes}/>'


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;")


def panel_svg(panel, left, x_label):
    xs = [x for s in panel.series for x, _ in s.points]
    ys = [y for s in panel.series for _, y in s.points]
    across = Scale(xs, left + LEFT, left + WIDTH - RIGHT, True)
    up = Scale(ys, HEAD + HEIGHT - BOTTOM, HEAD + TOP, panel.log_y)
    out = []
    for value in across.ticks():
        x = across(value)
        out.append(f'<line class="grid" x1="{x:.1f}" x2="{x:.1f}" y1="{up.begin}" y2="{up.end}"/>'
                   f'<text x="{x:.1f}" y="{up.begin + 16}" text-anchor="middle">{tick_text(value)}</text>')
    for value in up.ticks():
        y = up(value)
        out.append(f'<line class="grid" x1="{across.begin}" x2="{across.end}" y1="{y:.1f}" y2="{y:.1f}"/>'
                   f'<text x="{across.begin - 5}" y="{y + 4:.1f}" text-anchor="end">{tick_text(value)}</text>')
    out.append(line([(across.begin, up.end), (across.begin, up.begin), (across.end, up.begin)], 'class="axis"'))
    out.append(f'<text x="{across.begin}" y="{HEAD + TOP - 12}">{escaped(panel.label)}</text>')
    out.append(f'<text x="{(across.begin + across.end) / 2}" y="{up.begin + 34}" text-anchor="middle">'
               f'{escaped(x_label)}</text>')
    if panel.guide:
        name, value = panel.guide
        x0, y0 = panel.series[0].points[0]
        factor = 0.5 * y0 / value(x0, math.log)
        shown = sorted({x for x in xs if min(ys) <= factor * value(x, math.log) <= max(ys)})
        path = [(across(x), up(factor * value(x, math.log))) for x in shown]
        if len(path) > 1:
            out.append(line(path, 'class="guide"'))
            out.append(f'<text class="note" x="{path[-1][0] - 8:.1f}" y="{path[-1][1] + 26:.1f}" text-anchor="end">'
                       f'{escaped(name)}</text>')
    for k, series in enumerate(panel.series):
        colour, dash = STYLES[k % len(STYLES)]
        places = [(across(x), up(y)) for x, y in series.points]
        out.append(line(places, f'fill="none" stroke="{colour}" stroke-width="1.8" stroke-dasharray="{dash}"'))
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.4" fill="{colour}"/>' for x, y in places]
    return out


def picture(title, x_label, panels):
    """An SVG file. All panels have the same series in the same order."""
    width, height = len(panels) * WIDTH + LEGEND, HEAD + HEIGHT
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">',
           f"<style>{CSS}</style>", f'<rect class="paper" width="{width}" height="{height}"/>',
           f'<text class="title" x="{LEFT}" y="22">{escaped(title)}</text>']
    for k, panel in enumerate(panels):
        out += panel_svg(panel, k * WIDTH, x_label)
    for k, series in enumerate(panels[0].series):
        colour, dash = STYLES[k % len(STYLES)]
        x, y = len(panels) * WIDTH + 6, HEAD + TOP + 18 * k
        out.append(line([(x, y), (x + 24, y)], f'stroke="{colour}" stroke-width="1.8" stroke-dasharray="{dash}"'))
        out.append(f'<circle cx="{x + 12}" cy="{y}" r="2.4" fill="{colour}"/>'
                   f'<text x="{x + 30}" y="{y + 4}">{escaped(series.name)}</text>')
    return "\n".join(out + ["</svg>", ""])
