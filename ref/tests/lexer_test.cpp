/// The lexical rules of FORMAT, each at its edges.
#include "../src/lexer.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref {
namespace {

Rational ratio(long p, long q) {
  return {Integer(p), Integer(q)};
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseNumber, ReadsEveryFormExactly) {
  const std::vector<std::pair<const char*, Rational>> cases = {{"0", 0},
                                                               {"-0", 0},
                                                               {"+7", 7},
                                                               {"007", 7},
                                                               {"2/4", ratio(1, 2)},
                                                               {"-3/9", ratio(-1, 3)},
                                                               {"0/5", 0},
                                                               {"+1/01", 1},
                                                               {"1.", 1},
                                                               {".5", ratio(1, 2)},
                                                               {"-0.75", ratio(-3, 4)},
                                                               {"1e3", 1000},
                                                               {"1E+3", 1000},
                                                               {"25e-2", ratio(1, 4)},
                                                               {"1.5e1", 15},
                                                               {"1.e0", 1},
                                                               {".5E1", 5},
                                                               {"0e1100", 0},
                                                               {"1e00001", 10},
                                                               {"0x10", 16},
                                                               {"0XfF", 255},
                                                               {"-0x1.8p-2", ratio(-3, 8)},
                                                               {"0x.8", ratio(1, 2)},
                                                               {"0x1.", 1},
                                                               {"0x1.P+4", 16},
                                                               {"0xe", 14},
                                                               {"0x1e3", 0x1e3},
                                                               {"0x0p4400", 0}};
  for (const auto& [text, value] : cases) EXPECT_EQ(parse_number(text), value) << text;
  const Rational smallest = parse_number("1e-1100"), largest = parse_number("1e1100");
  EXPECT_EQ(smallest * largest, Rational(1));
  EXPECT_EQ(parse_number("0x1p4400") * parse_number("0x1p-4400"), Rational(1));
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text : {"",
                           "+",
                           "-",
                           ".",
                           "e5",
                           ".e5",
                           "1e",
                           "1e+",
                           "1e1.5",
                           "1.2.3",
                           "--1",
                           "+-1",
                           "1/",
                           "/2",
                           "1/-2",
                           "1/+2",
                           "1//2",
                           "1/2/3",
                           "1.0/2",
                           "1/2.0",
                           "1/2e1",
                           "1e2/3",
                           "1/0",
                           "0/0",
                           "1/000",
                           "0x",
                           "0x.",
                           "0xp1",
                           "0x1p",
                           "0x1p+",
                           "0x1pa",
                           "0x1.2.3",
                           "0xg",
                           "x1",
                           "0x1/2",
                           "0x-1",
                           "1_000",
                           "1,5",
                           "nan",
                           "inf",
                           "-inf",
                           "1d5",
                           "1p3",
                           "0b1",
                           "1e1101",
                           "1e-1101",
                           "0e99999999999999999999999",
                           "0x1p4401",
                           "0x1p-4401",
                           "1f",
                           "0x1e+3",
                           "0x1p1e1",
                           "1e1e1",
                           " 1",
                           "1 "})
    EXPECT_THROW(parse_number(text), InvalidInput) << text;
}

TEST(ParseNumber, TokensAreReadBackAsWritten) {
  for (const char* text : {"0", "-1", "3/4", "-22/7"}) EXPECT_EQ(number_token(parse_number(text)), text);
  EXPECT_THROW(number_token(parse_number("0x" + std::string(4000, 'f'))), LimitReached);
}

TEST(Lexer, SplitsAtWhiteSpaceAndComments) {
  Lexer lexer("a\tb\vc\fd\re#not f\n\n  f g#\xff\x01 anything\nh ", "t");
  for (const char* token : {"a", "b", "c", "d", "e", "f", "g", "h"}) EXPECT_EQ(lexer.word("a word"), token);
  EXPECT_EQ(lexer.peek(), "");
  lexer.expect_end("word");
}

TEST(Lexer, ACommentMayEndTheFile) {
  Lexer lexer("a# and no line break", "t");
  EXPECT_EQ(lexer.word("a word"), "a");
  lexer.expect_end("word");
}

TEST(Lexer, ATokenMustBeFollowedBySomething) {
  Lexer lexer("a b", "t");
  EXPECT_EQ(lexer.word("a word"), "a");
  EXPECT_NE(message_of([&] { lexer.word("a word"); }).find("t:1: the file ends directly after \"b\""),
            std::string::npos);
}

TEST(Lexer, RefusesOtherBytes) {
  for (const std::string& text :
       {std::string("\0 ", 2), std::string("\x7f "), std::string("\x80 "),
        std::string("\xef\xbb\xbf flatdt "), std::string("a\x1f "), std::string("\x08 ")}) {
    Lexer lexer(text, "t");
    EXPECT_THROW(lexer.word("a word"), InvalidInput);
  }
  for (char c = 0x21; c < 0x7f; ++c) {
    if (c == '#') continue;
    const std::string text = {c, ' '};
    Lexer lexer(text, "t");
    EXPECT_EQ(lexer.word("a word").size(), 1U);
  }
}

TEST(Lexer, TokensHaveALimit) {
  const std::string longest(kMaxTokenBytes, '1');
  const std::string text = longest + " " + longest + "1 ";
  Lexer lexer(text, "t");
  EXPECT_EQ(lexer.number("a number").numerator().to_string(), longest);
  EXPECT_NE(message_of([&] { lexer.number("a number"); }).find("longer than the limit of 4096 bytes"),
            std::string::npos);
}

TEST(Lexer, CountsAndIndicesHaveBounds) {
  Lexer lexer("10 11 0010 2 3 -1 +1 1.0 0x1 18446744073709551616 ", "t");
  EXPECT_EQ(lexer.count("n", 10), 10U);
  EXPECT_EQ(message_of([&] { lexer.count("n", 10); }), "t:1: n: \"11\" is beyond the limit of 10");
  EXPECT_EQ(lexer.count("n", 10), 10U);
  EXPECT_EQ(lexer.index("i", 3), 2U);
  EXPECT_EQ(message_of([&] { lexer.index("i", 3); }),
            "t:1: i: \"3\" is out of range: they are numbered from 0 to 2");
  for (int i = 0; i < 5; ++i) EXPECT_THROW(lexer.count("n", 10), InvalidInput);
  EXPECT_THROW(lexer.index("i", 0), InvalidInput);
}

TEST(Lexer, MessagesNameTheLineOfTheToken) {
  Lexer lexer("one # 1\n# 2\n\ntwo\nthree\n", "dir/file");
  lexer.expect("one");
  EXPECT_EQ(message_of([&] { lexer.expect("2"); }), "dir/file:4: \"two\" stands where \"2\" must stand");
  lexer.expect("two");
  EXPECT_EQ(message_of([&] { lexer.expect_end("section"); }),
            "dir/file:5: \"three\" stands after the last section");
  lexer.expect("three");
  EXPECT_EQ(message_of([&] { lexer.word("a count"); }), "dir/file:6: the file ends where a count must stand");
}

TEST(Lexer, ReadsAugmentedMatricesRowByRow) {
  Lexer lexer("1 2 1/3\n4 5 6 ", "t");
  const Isometry g = lexer.isometry(2, "an element");
  EXPECT_EQ(isometry_tokens(g), "1 2 1/3 4 5 6");
  EXPECT_EQ(g.translation[0], ratio(1, 3));
}

}  // namespace
}  // namespace flatdt::ref
