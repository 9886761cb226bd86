/// Texts as instance files: both parsers accept the same texts, refuse others at the same line, and read the
/// same data; what ref writes means what it read.
#include <cstdlib>
#include <map>

#include "../engine/expect.hpp"
#include "../engine/laws.hpp"
#include "../engine/memory_stream.hpp"
#include "../engine/target.hpp"
#include "flatdt/checker/errors.hpp"
#include "flatdt/checker/input.hpp"
#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "line_of.hpp"

namespace {

using flatdt::fuzz::expect;
namespace checker = flatdt::checker;
namespace ref = flatdt::ref;

bool same(const ref::Matrix& a, const checker::Mat<checker::Rational>& b, int d) {
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < d; ++j)
      if (a(i, j).mpq() != b[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) return false;
  return true;
}

bool same(const ref::Vector& a, const checker::Vec<checker::Rational>& b, int d) {
  for (int i = 0; i < d; ++i)
    if (a[i].mpq() != b[static_cast<std::size_t>(i)]) return false;
  return true;
}

void expect_same(const ref::Instance& a, const checker::Instance& b) {
  const int d = a.dimension;
  expect(d == b.dimension, "both parsers read one dimension");
  expect(a.name.has_value() == b.claim.has_value(), "both parsers read a claim or none");
  if (a.name) expect(ref::find_entry(*a.name)->name == *b.claim, "both parsers read one claim");
  expect(same(a.gram, b.metric, d), "both parsers read one metric");
  expect(a.generators.size() == b.generators.size(), "both parsers read as many generators");
  for (std::size_t k = 0; k < a.generators.size(); ++k)
    expect(same(a.generators[k].linear, b.generators[k].linear, d) &&
               same(a.generators[k].translation, b.generators[k].translation, d),
           "both parsers read the same generators");
  expect(a.points.size() == b.points.size(), "both parsers read as many points");
  for (std::size_t k = 0; k < a.points.size(); ++k)
    expect(same(a.points[k], b.points[k], d), "both parsers read the same points");
}

void expect_round_trip(const ref::Instance& instance) {
  std::string text;
  try {
    text = ref::write_instance(instance);
  } catch (const ref::LimitReached&) {
    return;  // a sum of exponents may be longer than a token
  }
  const ref::Instance again = ref::parse_instance(text, "again");
  expect(again.points == instance.points && again.gram == instance.gram && again.name == instance.name &&
             again.generators == instance.generators && again.generators_given == instance.generators_given,
         "what is written means what was read");
  expect(ref::write_instance(again) == text, "what is written is canonical");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::optional<ref::Instance> by_ref;
  std::optional<checker::Instance> by_checker;
  long ref_line = 0;
  long checker_line = 0;
  try {
    by_ref = ref::parse_instance(text, "f");
  } catch (const ref::InvalidInput& error) {
    ref_line = flatdt::fuzz::line_of(error.what());
  }
  try {
    flatdt::fuzz::MemoryStream in(text);
    by_checker = checker::parse_instance(in, "f");
  } catch (const checker::MalformedInput& error) {
    checker_line = flatdt::fuzz::line_of(error.what());
  }
  if (by_ref && by_checker) {
    expect_same(*by_ref, *by_checker);
    if (flatdt::fuzz::is_asked({data, size}, 0, 4)) expect_round_trip(*by_ref);
  } else if (by_ref) {
    // For ref the metric belongs to the group, which is looked at later.
    expect(!ref::is_positive_definite(by_ref->gram), "the checker refuses what is wrong only");
  } else if (by_checker) {
    expect(false, "ref refuses what is wrong only");
  } else {
    expect(ref_line > 0 && ref_line >= checker_line, "both parsers name a line");
  }
  return 0;
}
