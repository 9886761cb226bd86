// Builders of input texts for the tests, and the judge applied to texts.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "flatdt/checker/check.hpp"
#include "flatdt/checker/errors.hpp"

namespace flatdt::checker::test {

inline Instance read_instance(const std::string& text) {
  std::istringstream in(text);
  return parse_instance(in, "instance");
}

inline Triangulation read_triangulation(const std::string& text, const Instance& instance) {
  std::istringstream in(text);
  return parse_triangulation(in, "triangulation", instance);
}

inline Verdict judge(const std::string& instance_text, const std::string& triangulation_text) {
  const Instance instance = read_instance(instance_text);
  return check(instance, read_triangulation(triangulation_text, instance));
}

/// One letter for each condition in order: h(olds), f(ails), s(kipped); grouped as group, subgroup, the six
/// of the tiling, simplices and skeleton and intersection, links, topology.
inline std::string statuses(const Verdict& verdict) {
  std::string text;
  for (std::size_t i = 0; i < kConditionCount; ++i) {
    if (i == 3 || i == 4 || i == 10 || i == 14 || i == 15) text += ' ';
    text += to_string(verdict.conditions[i].status)[0];
  }
  return text;
}

/// That these are the statuses, written as by statuses().
inline void expect(const Verdict& verdict, const std::string& expected, Outcome outcome) {
  EXPECT_EQ(statuses(verdict), expected) << verdict.reason;
  EXPECT_EQ(verdict.outcome, outcome) << verdict.reason;
}

/// The value of a witness's key, or "".
inline std::string witness(const Verdict& verdict, ConditionName name, const std::string& key) {
  for (const auto& [k, value] : verdict[name].witness) {
    if (k == key) return value;
  }
  return "";
}

/// A triangulation file under construction: vertices are (point, text of an element).
struct TriangulationText {
  using CellVertices = std::vector<std::pair<std::size_t, std::string>>;

  std::vector<std::string> subgroup;
  bool has_subgroup = false;
  std::vector<std::string> extra_elements;
  std::vector<CellVertices> cells;

  [[nodiscard]] std::string str() const {
    std::map<std::string, std::size_t> ids;
    std::vector<std::string> elements = extra_elements;
    std::ostringstream body;
    for (const CellVertices& cell : cells) {
      for (const auto& [point, element] : cell) {
        const auto [it, inserted] = ids.try_emplace(element, elements.size());
        if (inserted) elements.push_back(element);
        body << ' ' << point << ' ' << it->second;
      }
      body << '\n';
    }
    std::ostringstream out;
    out << "flatdt-triangulation 1\n";
    if (has_subgroup || !subgroup.empty()) {
      out << "subgroup " << subgroup.size() << '\n';
      for (const std::string& g : subgroup) out << g << '\n';
    }
    out << "elements " << elements.size() << '\n';
    for (const std::string& g : elements) out << g << '\n';
    out << "cells " << cells.size() << '\n' << body.str();
    return out.str();
  }
};

/// The translation by v as an element.
inline std::string shift(const std::vector<int>& v) {
  std::string text;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) text += i == j ? "1 " : "0 ";
    text += std::to_string(v[i]) + " ";
  }
  return text;
}

inline int floor_div(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// The vertex of the torus grid of points (x/m, y/n), numbered x + m y, at (x/m, y/n) for any integers x, y.
inline std::pair<std::size_t, std::string> grid_vertex(int x, int y, int m, int n) {
  const int a = floor_div(x, m);
  const int b = floor_div(y, n);
  return {static_cast<std::size_t>((x - a * m) + m * (y - b * n)), shift({a, b})};
}

/// Instance: the square torus with the grid points (x/m, y/n).
inline std::string grid_instance(int m, int n, const std::string& metric = "",
                                 const std::string& more_points = "", int more = 0) {
  std::ostringstream out;
  out << "flatdt-instance 1 dimension 2 generators 2 1 0 1 0 1 0  1 0 0 0 1 1 ";
  if (!metric.empty()) out << "metric " << metric << ' ';
  out << "points " << m * n + more << '\n';
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < m; ++x) out << x << '/' << m << ' ' << y << '/' << n << '\n';
  }
  out << more_points << '\n';
  return out.str();
}

/// The grid's rectangles, split by the diagonals (x,y)-(x+1,y+1).
inline TriangulationText grid_triangulation(int m, int n) {
  TriangulationText t;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < m; ++x) {
      const auto v = [&](int dx, int dy) { return grid_vertex(x + dx, y + dy, m, n); };
      t.cells.push_back({v(0, 0), v(1, 0), v(1, 1)});
      t.cells.push_back({v(0, 0), v(0, 1), v(1, 1)});
    }
  }
  return t;
}

/// Kuhn's triangulation of Z^3 (one point, the cubic torus), modulo (k Z)^3.
inline const char* cubic_point() {
  return "flatdt-instance 1 dimension 3 manifold torocosm points 1 0 0 0\n";
}
inline TriangulationText kuhn_triangulation(int k) {
  TriangulationText t;
  t.subgroup = {shift({k, 0, 0}), shift({0, k, 0}), shift({0, 0, k})};
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int x = 0; x < k * k * k; ++x) {
    for (const auto& order : orders) {
      std::vector<int> v = {x % k, x / k % k, x / (k * k)};
      TriangulationText::CellVertices cell = {{0, shift(v)}};
      for (const int axis : order) {
        ++v[static_cast<std::size_t>(axis)];
        cell.emplace_back(0, shift(v));
      }
      t.cells.push_back(cell);
    }
  }
  return t;
}

}  // namespace flatdt::checker::test
