/// A case under edit: a copy of the base whose cells, elements and instance may be changed.
#pragma once

#include <map>
#include <optional>

#include "edit.hpp"

namespace flatdt::edits {

class Draft {
 public:
  explicit Draft(const Base& base) : case_(base.valid()) {}
  explicit Draft(Case start) : case_(std::move(start)) {}

  [[nodiscard]] Case& data() { return case_; }
  [[nodiscard]] const Case& data() const { return case_; }
  [[nodiscard]] ref::Instance& instance() { return case_.instance; }
  [[nodiscard]] ref::Triangulation& triangulation() { return case_.triangulation; }
  [[nodiscard]] std::vector<FileCell>& cells() { return case_.triangulation.cells; }
  [[nodiscard]] const ref::Isometry& element(FileVertex v) const {
    return case_.triangulation.elements[v.element];
  }

  /// The index of an element, appended if it is not in the list.
  std::uint32_t index_of(const ref::Isometry& g);
  /// The vertex g v.
  FileVertex moved(const ref::Isometry& g, FileVertex v) { return {v.point, index_of(g * element(v))}; }
  /// The cell g c.
  FileCell moved(const ref::Isometry& g, FileCell cell);
  /// Removes the cells whose numbers are given.
  void remove_cells(std::vector<std::size_t> numbers);
  /// Makes the instance state its generators.
  void set_generators(std::vector<ref::Isometry> generators);

  [[nodiscard]] Files files() const;

 private:
  Case case_;
  std::map<ref::Isometry, std::uint32_t> index_;
};

/// The vertex of the file at a corner of a cell of the base.
[[nodiscard]] inline FileVertex file_vertex(const Base& base, std::size_t cell, std::size_t corner) {
  return base.triangulation().cells[cell][corner];
}

}  // namespace flatdt::edits
