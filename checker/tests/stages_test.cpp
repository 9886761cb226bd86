// Wide integers and the flat map against GMP and std::map, and the verdict with every stage forced.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>

#include "build.hpp"
#include "flatdt/checker/errors.hpp"
#include "id_map.hpp"
#include "wide.hpp"

namespace flatdt::checker::test {
namespace {

Integer value_of(const Integer& magnitude, bool negative) {
  return negative ? Integer(-magnitude) : magnitude;
}

template <std::size_t N>
Integer value_of(const Wide<N>& x) {
  return value_of(to_integer(magnitude(x)), x.is_negative());
}

/// Random limbs, of which many are all zeros or all ones.
template <std::size_t N>
Wide<N> random_wide(std::mt19937_64& random) {
  Wide<N> x;
  for (std::uint64_t& limb : x.limb) limb = random() % 3 == 0 ? random() : (random() % 2 == 0 ? 0 : ~0ULL);
  if (random() % 2 == 0) x.limb[N - 1] ^= random() % 3;
  return x;
}

template <std::size_t A, std::size_t B>
void compare_products(std::mt19937_64& random) {
  for (int round = 0; round < 3000; ++round) {
    const Wide<A> a = random_wide<A>(random);
    const Wide<B> b = random_wide<B>(random);
    if (sign_of(magnitude(a)) == Sign::negative || sign_of(magnitude(b)) == Sign::negative) continue;
    const Integer product = value_of(a) * value_of(b);
    ASSERT_EQ(value_of(a * b), product);
    ASSERT_EQ(sign_of(a * b), sign_of(product));
    const Wide<A + B> wider = a.template widened<A + B>();
    ASSERT_EQ(value_of(wider), value_of(a));
    ASSERT_EQ(value_of(wider - b.template widened<A + B>()), value_of(a) - value_of(b));
    ASSERT_EQ(value_of(wider + b.template widened<A + B>()), value_of(a) + value_of(b));
  }
}

TEST(Wide, AgreesWithGmp) {
  std::mt19937_64 random(5);
  compare_products<1, 1>(random);
  compare_products<2, 1>(random);
  compare_products<1, 3>(random);
  compare_products<2, 4>(random);
}

TEST(IdMap, AgreesWithTheStandardMap) {
  std::mt19937_64 random(6);
  for (const std::uint64_t spread : {7ULL, 1000ULL, ~0ULL}) {
    IdMap flat;
    std::map<std::uint64_t, std::uint32_t> reference;
    for (std::uint32_t i = 0; i < 20'000; ++i) {
      const std::uint64_t key = random() % spread;
      const auto known = reference.find(key);
      EXPECT_EQ(flat.find(key), known == reference.end() ? IdMap::kAbsent : known->second);
      EXPECT_EQ(flat.insert(key, i), reference.try_emplace(key, i).first->second);
    }
    flat.clear();
    EXPECT_EQ(flat.find(reference.begin()->first), IdMap::kAbsent);
  }
}

/// The inverse of the map's mixing.
std::uint64_t unmix(std::uint64_t x) {
  x ^= (x >> 31) ^ (x >> 62);
  x *= 0x319642b2d24d8ec3U;
  x ^= (x >> 27) ^ (x >> 54);
  x *= 0x96de1b173f119089U;
  return x ^ (x >> 30) ^ (x >> 60);
}

// Keys that all want the same places of every table up to 2^32 places: they end in the ordered map.
TEST(IdMap, KeysMadeToCollide) {
  IdMap flat;
  constexpr std::uint32_t kKeys = 100'000;
  for (std::uint32_t i = 0; i < kKeys; ++i) flat.insert(unmix(std::uint64_t{i} << 32), i);
  EXPECT_GT(flat.overflow(), kKeys - 20U);
  for (std::uint32_t i = 0; i < kKeys; ++i) ASSERT_EQ(flat.find(unmix(std::uint64_t{i} << 32)), i);
  for (std::uint32_t i = 0; i < 1000; ++i) flat.insert(i, i);  // grows, and everything is inserted anew
  for (std::uint32_t i = 0; i < kKeys; ++i) ASSERT_EQ(flat.find(unmix(std::uint64_t{i} << 32)), i);
}

/// All that a verdict says.
std::string text_of(const Verdict& verdict) {
  std::string text = std::string(to_string(verdict.outcome)) + " " + verdict.reason;
  for (const Condition& condition : verdict.conditions) {
    text += '\n';
    text += to_string(condition.status);
    for (const auto& [key, value] : condition.witness) text += " " + key + "=" + value;
  }
  return text;
}

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Stages, GiveTheSameVerdictOnAllCorpora) {
  int judged = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(FLATDT_CORPORA)) {
    const std::filesystem::path& path = entry.path();
    std::filesystem::path instance_path = path;
    instance_path.replace_extension("instance");
    if (path.extension() != ".triangulation" || !std::filesystem::exists(instance_path)) continue;
    try {
      const Instance instance = read_instance(contents(instance_path));
      const Triangulation triangulation = read_triangulation(contents(path), instance);
      const std::string expected = text_of(check(instance, triangulation));
      for (const bool filter : {false, true}) {
        for (const bool fixed_width : {false, true}) {
          const Stages stages{.filter = filter, .fixed_width = fixed_width};
          EXPECT_EQ(text_of(check(instance, triangulation, stages)), expected) << path;
        }
      }
      for (const unsigned jobs : {2U, 3U, 8U}) {
        EXPECT_EQ(text_of(check(instance, triangulation, {.jobs = jobs})), expected) << path << ' ' << jobs;
      }
      ++judged;
    } catch (const MalformedInput&) {  // of corpora/invalid/malformed
      continue;
    }
  }
  EXPECT_GT(judged, 200);
}

// What fails, fails in many places, of which each time the first is shown.
TEST(Stages, GiveTheSameVerdictForAnyNumberOfThreads) {
  constexpr int kSide = 75;
  const TriangulationText right = grid_triangulation(kSide, kSide);
  TriangulationText missing = right;
  TriangulationText doubled = right;
  for (const std::size_t c : {9'000U, 5'000U, 1'000U}) {
    missing.cells.erase(missing.cells.begin() + c);
    doubled.cells[c] = doubled.cells[c + 1];
  }
  const std::map<std::string, std::pair<const TriangulationText*, std::string>> cases = {
      {"right", {&right, "1 0 1"}},
      {"wrong metric", {&right, "2 1 2"}},
      {"metric beyond fixed width", {&right, "2e30 1e-30 2e30"}},
      {"missing cells", {&missing, "1 0 1"}},
      {"doubled cells", {&doubled, "1 0 1"}}};
  for (const auto& [name, parts] : cases) {
    const Instance instance = read_instance(grid_instance(kSide, kSide, parts.second));
    const Triangulation triangulation = read_triangulation(parts.first->str(), instance);
    const Verdict one = check(instance, triangulation);
    EXPECT_EQ(one.outcome, name == "right" ? Outcome::verified : Outcome::refuted) << name;
    for (const unsigned jobs : {2U, 3U, 8U}) {
      EXPECT_EQ(text_of(check(instance, triangulation, {.jobs = jobs})), text_of(one)) << name << ' ' << jobs;
    }
  }
}

// One flipped diagonal in 11,250 cells, in the first, a middle and the last thread's range. In this metric
// the grid's diagonals are the short ones, so no other triangulation is Delaunay.
TEST(Stages, FindTheOneFlippedSquareWithAnyNumberOfThreads) {
  constexpr int kSide = 75;
  const Instance instance = read_instance(grid_instance(kSide, kSide, "1 -1/10 1"));
  const TriangulationText right = grid_triangulation(kSide, kSide);
  ASSERT_EQ(check(instance, read_triangulation(right.str(), instance)).outcome, Outcome::verified);
  for (const int square : {0, kSide * kSide / 2, kSide * kSide - 1}) {
    const auto v = [&](int dx, int dy) {
      return grid_vertex(square % kSide + dx, square / kSide + dy, kSide, kSide);
    };
    TriangulationText flipped = right;
    const auto cell = flipped.cells.begin() + 2 * square;
    cell[0] = {v(0, 0), v(1, 0), v(0, 1)};
    cell[1] = {v(1, 0), v(0, 1), v(1, 1)};
    const Triangulation triangulation = read_triangulation(flipped.str(), instance);
    const Verdict one = check(instance, triangulation);
    EXPECT_EQ(one[ConditionName::delaunay_empty].status, Status::fails) << square;
    for (const unsigned jobs : {2U, 3U, 8U}) {
      EXPECT_EQ(text_of(check(instance, triangulation, {.jobs = jobs})), text_of(one))
          << square << ' ' << jobs;
    }
  }
}

}  // namespace
}  // namespace flatdt::checker::test
