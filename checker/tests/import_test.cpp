// Importers: streams that CGAL wrote are judged as what they are; anything else is refused with its place.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "../importers/cgal_stream.hpp"
#include "flatdt/checker/check.hpp"
#include "flatdt/checker/errors.hpp"

namespace flatdt::checker {
namespace {

const std::filesystem::path kStreams = std::filesystem::path(FLATDT_CORPORA) / "imports";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Imported imported(const std::string& text, int dimension) {
  std::istringstream in(text);
  return import_cgal(in, "stream", dimension);
}

Verdict verdict_of(const std::string& text, int dimension) {
  const Imported i = imported(text, dimension);
  return check(i.instance, i.triangulation);
}

/// The message of the refusal; empty if there is none.
std::string refusal(const std::string& text, int dimension) {
  try {
    static_cast<void>(imported(text, dimension));
    return {};
  } catch (const MalformedInput& error) {
    return error.what();
  }
}

std::vector<std::string> tokens_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

std::string joined(const std::vector<std::string>& tokens) {
  std::string text;
  for (const std::string& t : tokens) text += t + "\n";
  return text;
}

struct Stream {
  const char* file;
  int dimension;
  std::size_t points, cells;
  bool cover;
};

// What is in corpora/imports.
const std::vector<Stream> kAll{{"square-one-sheet.p2t2", 2, 64, 128, false},
                               {"square-nine-sheets.p2t2", 2, 5, 90, true},
                               {"cube-one-sheet.p3t3", 3, 125, 869, false},
                               {"cube-27-sheets.p3t3", 3, 3, 540, true}};

TEST(CgalStream, RightOnesAreVerified) {
  for (const Stream& s : kAll) {
    SCOPED_TRACE(s.file);
    const Imported i = imported(text_of(kStreams / s.file), s.dimension);
    EXPECT_EQ(i.instance.points.size(), s.points);
    EXPECT_EQ(i.triangulation.cells.size(), s.cells);
    EXPECT_EQ(i.triangulation.subgroup.has_value(), s.cover);
    const Verdict v = check(i.instance, i.triangulation);
    EXPECT_EQ(v.outcome, Outcome::verified) << v.reason;
    EXPECT_NE(i.note.find("neighbours are not judged"), std::string::npos);
  }
}

TEST(CgalStream, NeedsNoLineBreakAtTheEnd) {
  std::string text = text_of(kStreams / "square-nine-sheets.p2t2");
  while (text.back() == '\n' || text.back() == ' ') text.pop_back();
  EXPECT_EQ(verdict_of(text, 2).outcome, Outcome::verified);
}

// 1 x 1 torus, one sheet, nine points of a grid of thirds given as decimals: their exact values make no grid.
TEST(CgalStream, ShortDecimalsAreTakenAsTheyStandAndSaidSo) {
  std::vector<std::string> tokens = tokens_of(text_of(kStreams / "cube-27-sheets.p3t3"));
  const std::size_t vertices = 9;
  ASSERT_EQ(tokens[vertices], "81");
  for (std::size_t v = 0; v < 81; ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      std::string& token = tokens[vertices + 1 + 6 * v + k];
      char shorter[32];
      std::snprintf(shorter, sizeof shorter, "%.6g", std::stod(token));
      token = shorter;
    }
  EXPECT_NE(imported(joined(tokens), 3).note.find("set the stream's precision to 17"), std::string::npos);
  EXPECT_EQ(imported(text_of(kStreams / "cube-27-sheets.p3t3"), 3).note.find("precision"), std::string::npos);
}

TEST(CgalStream, WrongOnesAreRefuted) {
  // An offset changed, a vertex of a cell replaced, the cells of one sheet claimed for 27.
  for (const Stream& s : kAll) {
    SCOPED_TRACE(s.file);
    std::vector<std::string> tokens = tokens_of(text_of(kStreams / s.file));
    tokens.back() = tokens.back() == "0" ? "1" : "0";
    EXPECT_EQ(verdict_of(joined(tokens), s.dimension).outcome, Outcome::refuted);
  }
}

TEST(CgalStream, EveryCutIsRefused) {
  const std::vector<std::string> tokens = tokens_of(text_of(kStreams / "square-nine-sheets.p2t2"));
  for (std::size_t n = 0; n < tokens.size(); ++n) {
    std::vector<std::string> cut(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(n));
    EXPECT_NE(refusal(joined(cut), 2), "") << n << " of " << tokens.size() << " tokens";
  }
}

TEST(CgalStream, EveryBadTokenIsRefusedOrJudged) {
  const std::vector<std::string> tokens = tokens_of(text_of(kStreams / "square-nine-sheets.p2t2"));
  std::map<Outcome, int> seen;
  for (const char* bad : {"-1", "nan", "1e9999", "99999999999999999999", "x", "0", "1/0", "3"})
    for (std::size_t n = 0; n < tokens.size(); n += 1 + n / 40) {
      std::vector<std::string> changed = tokens;
      changed[n] = bad;
      if (refusal(joined(changed), 2).empty()) ++seen[verdict_of(joined(changed), 2).outcome];
    }
  EXPECT_EQ(seen.count(Outcome::unknown), 0U);
  EXPECT_GT(seen[Outcome::refuted], 0);
}

TEST(CgalStream, RefusalsSayWhatIsWrongAndWhere) {
  const struct {
    const char* text;
    int dimension;
    const char* message;
  } kCases[] = {
      {"0 0 1 1\n0 0\n0\n", 2, "stream:2: a number of sheets must be from 1 to 3, found '0'"},
      {"0 0 1 1\n1 3\n9\n", 2, "stream:2: the numbers of sheets must all be 1 or all be 3, found '3'"},
      {"0 0 1 1\n2 2\n9\n", 2, "must all be 1 or all be 3, found '2'"},
      {"0 0 0 1\n1 1\n1\n", 2, "the domain is empty"},
      {"0 0 1 1\n1 1\n0\n", 2, "stream:3: the number of vertices must be from 1"},
      {"0 0 1 1\n3 3\n10\n", 2,
       "stream:3: the number of vertices must be a multiple of the 9 sheets, found '10'"},
      {"0 0 1 1\n1 1\n1\n0.5 0.5\n1\n0 0 1\n", 2,
       "stream:6: the index of a vertex must be from 0 to 0, found '1'"},
      {"0 0 1 1\n1 1\n1\n0.5 0.5\n2\n0 0 0 0 0 0\n1 1 1 0 0 2\n", 2,
       "the index of a neighbour must be from 0 to 1"},
      {"0 0 1 1\n1 1\n1\n0.5 0.5\n1\n0 0 0\n0 0 0\n0 0 4\n", 2, "the offset of a corner must be from 0 to 3"},
      {"0 0 1 1\n1 1\n1\n0.5 0.5\n1\n0 0 0\n0 0 0\n0 0 3 red", 2,
       "expected the end of the file, found 'red'"},
      {"0 0 1 1\n1 1\n1\n0.5 inf\n", 2, "stream:4: a coordinate: "},
      {"0 0 1 1\n1 1\n100000000\n0.5 0.5\n", 2, "the file ends where a coordinate must stand"},
      {"\x03\x00\x7f", 3, "byte 0x03 is not allowed"},
  };
  for (const auto& c : kCases)
    EXPECT_NE(refusal(c.text, c.dimension).find(c.message), std::string::npos)
        << c.text << "\n"
        << refusal(c.text, c.dimension);
}

TEST(CgalStream, OfTheOtherDimensionIsRefused) {
  EXPECT_NE(refusal(text_of(kStreams / "square-nine-sheets.p2t2"), 3), "");
  EXPECT_NE(refusal(text_of(kStreams / "cube-27-sheets.p3t3"), 2), "");
}

}  // namespace
}  // namespace flatdt::checker
