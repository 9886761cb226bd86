/// Specimens as bytes. Section after section, each with its count before it; counts and indices are taken
/// modulo their bounds.
#include "byte_stream.hpp"
#include "flatdt/ref/lattice.hpp"
#include "specimen.hpp"

namespace flatdt::fuzz {
namespace {

enum Flag : int { kNameOnly = 1, kHasChange = 2, kHasGram = 4, kHasSubgroup = 8 };
constexpr int kListedElement = 255;  // in the place of a coset: the numbers of any affine map follow

int group_count() {
  return static_cast<int>(named_groups().size()) + 2;
}

int claim_count() {
  return static_cast<int>(named_groups().size()) + 1;
}

/// A name of the other dimension would make every such file malformed: the parsers' targets see to those.
bool can_claim(const Specimen& specimen, int claim) {
  return claim == 0 ||
         named_groups()[static_cast<std::size_t>(claim) - 1].entry->dimension == specimen.dimension();
}

ref::Matrix read_gram(ByteReader& in, int dimension) {
  ref::Matrix gram(dimension);
  for (int i = 0; i < dimension; ++i) {
    for (int j = i; j < dimension; ++j) {
      gram(i, j) = in.rational();
      gram(j, i) = gram(i, j);
    }
  }
  return gram;
}

void write_gram(ByteWriter& out, const ref::Matrix& gram) {
  for (int i = 0; i < gram.dimension(); ++i)
    for (int j = i; j < gram.dimension(); ++j) out.rational(gram(i, j));
}

CodedElement read_element(ByteReader& in, const Specimen& specimen) {
  CodedElement element;
  const int d = specimen.dimension();
  const int coset = in.byte();
  if (specimen.named() == nullptr || coset == kListedElement) {
    element.listed = in.isometry(d);
    return element;
  }
  element.coset = static_cast<std::uint8_t>(coset % static_cast<int>(specimen.named()->cosets.size()));
  for (int i = 0; i < d; ++i)
    element.shift[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(in.byte());
  return element;
}

void write_element(ByteWriter& out, const Specimen& specimen, const CodedElement& element) {
  if (element.listed) {
    out.byte(kListedElement);
    out.isometry(*element.listed);
    return;
  }
  out.byte(element.coset);
  for (int i = 0; i < specimen.dimension(); ++i) out.byte(element.shift[static_cast<std::size_t>(i)]);
}

void read_triangulation(ByteReader& in, Specimen& specimen) {
  if (specimen.has_subgroup) {
    const int generators = in.below(kMaxGenerators + 1);
    for (int k = 0; k < generators; ++k) specimen.subgroup.push_back(read_element(in, specimen));
  }
  const int elements = in.below(kMaxElements + 1);
  for (int k = 0; k < elements; ++k) specimen.elements.push_back(read_element(in, specimen));
  const int low = in.byte();
  const int cells = elements == 0 ? 0 : (low + 256 * in.byte()) % (kMaxCells + 1);
  const auto points = static_cast<int>(specimen.points.size());
  for (int k = 0; k < cells; ++k) {
    CodedCell cell{};
    for (int i = 0; i <= specimen.dimension(); ++i)
      cell[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(in.below(points)),
                                           static_cast<std::uint8_t>(in.below(elements))};
    specimen.cells.push_back(cell);
  }
}

void write_triangulation(ByteWriter& out, const Specimen& specimen) {
  if (specimen.has_subgroup) {
    out.byte(static_cast<int>(specimen.subgroup.size()));
    for (const CodedElement& element : specimen.subgroup) write_element(out, specimen, element);
  }
  out.byte(static_cast<int>(specimen.elements.size()));
  for (const CodedElement& element : specimen.elements) write_element(out, specimen, element);
  out.byte(static_cast<int>(specimen.cells.size() % 256));
  if (specimen.elements.empty()) return;
  out.byte(static_cast<int>(specimen.cells.size() / 256));
  for (const CodedCell& cell : specimen.cells) {
    for (int i = 0; i <= specimen.dimension(); ++i) {
      out.byte(cell[static_cast<std::size_t>(i)].point);
      out.byte(cell[static_cast<std::size_t>(i)].element);
    }
  }
}

void read_queries(ByteReader& in, Specimen& specimen) {
  const int queries = in.below(kMaxQueries + 1);
  for (int k = 0; k < queries; ++k) {
    CodedQuery query;
    query.point = static_cast<std::uint8_t>(in.below(static_cast<int>(specimen.points.size())));
    query.coset = in.byte();
    for (int i = 0; i < specimen.dimension(); ++i)
      query.shift[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(in.byte());
    specimen.queries.push_back(query);
  }
}

void write_queries(ByteWriter& out, const Specimen& specimen) {
  out.byte(static_cast<int>(specimen.queries.size()));
  for (const CodedQuery& query : specimen.queries) {
    out.byte(query.point);
    out.byte(query.coset);
    for (int i = 0; i < specimen.dimension(); ++i) out.byte(query.shift[static_cast<std::size_t>(i)]);
  }
}

void read_named_group(ByteReader& in, Specimen& specimen, int flags) {
  specimen.name_only = (flags & kNameOnly) != 0;
  const int words = in.below(kMaxWords + 1);
  for (int k = 0; k < words; ++k) specimen.words.push_back(in.byte());
  if ((flags & kHasChange) == 0) return;
  const ref::Isometry change = in.isometry(specimen.dimension());
  if (!change.linear.determinant().is_zero()) specimen.change = change;
}

}  // namespace

Specimen decode(std::span<const std::uint8_t> bytes, const Shape& shape) {
  ByteReader in(bytes);
  Specimen specimen;
  specimen.group = in.below(group_count());
  const int flags = in.byte();
  specimen.claim = in.below(claim_count());
  specimen.has_subgroup = shape.triangulation && (flags & kHasSubgroup) != 0;
  const int d = specimen.dimension();
  if (!can_claim(specimen, specimen.claim)) specimen.claim = 0;
  if (specimen.named() != nullptr) {
    read_named_group(in, specimen, flags);
  } else {
    const int generators = 1 + in.below(kMaxGenerators);
    for (int k = 0; k < generators; ++k) specimen.generators.push_back(in.isometry(d));
  }
  if ((flags & kHasGram) != 0) specimen.gram = read_gram(in, d);
  const int points = 1 + in.below(kMaxPoints);
  for (int k = 0; k < points; ++k) specimen.points.push_back(in.vector(d));
  if (shape.triangulation) read_triangulation(in, specimen);
  if (shape.queries) read_queries(in, specimen);
  return specimen;
}

std::optional<std::vector<std::uint8_t>> encode(const Specimen& specimen, const Shape& shape) {
  ByteWriter out;
  out.byte(specimen.group);
  out.byte((specimen.name_only ? kNameOnly : 0) | (specimen.change ? kHasChange : 0) |
           (specimen.gram ? kHasGram : 0) | (specimen.has_subgroup ? kHasSubgroup : 0));
  out.byte(specimen.claim);
  if (specimen.named() != nullptr) {
    out.byte(static_cast<int>(specimen.words.size()));
    for (const std::uint8_t word : specimen.words) out.byte(word);
    if (specimen.change) out.isometry(*specimen.change);
  } else {
    out.byte(static_cast<int>(specimen.generators.size()) - 1);
    for (const ref::Isometry& g : specimen.generators) out.isometry(g);
  }
  if (specimen.gram) write_gram(out, *specimen.gram);
  out.byte(static_cast<int>(specimen.points.size()) - 1);
  for (const ref::Vector& x : specimen.points) out.vector(x);
  if (shape.triangulation) write_triangulation(out, specimen);
  if (shape.queries) write_queries(out, specimen);
  if (!out.fits()) return std::nullopt;
  return out.bytes();
}

}  // namespace flatdt::fuzz
