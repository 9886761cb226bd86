// NUMBER tokens, in both directions.   Source: FORMAT.md, "Lexical rules".
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "lexer.hpp"

namespace flatdt::checker {
namespace {

struct Case {
  const char* token;
  const char* value;
};

TEST(Number, AcceptsExactlyTheGrammar) {
  const Case cases[] = {
      {"0", "0"},        {"-0", "0"},           {"+7", "7"},       {"007", "7"},        {"1/2", "1/2"},
      {"-6/4", "-3/2"},  {"+0/5", "0"},         {"2/04", "1/2"},   {"1.", "1"},         {".5", "1/2"},
      {"-.25", "-1/4"},  {"1.50", "3/2"},       {"1e3", "1000"},   {"1E+3", "1000"},    {"1.e-2", "1/100"},
      {".5e1", "5"},     {"1e007", "10000000"}, {"0.1", "1/10"},   {"0x10", "16"},      {"0Xa", "10"},
      {"-0xFf", "-255"}, {"0x.8", "1/2"},       {"0x1.", "1"},     {"0x1.8p-2", "3/8"}, {"0x1.8P+1", "3"},
      {"0x1e5", "485"},  {"+0xAp0", "10"},      {"0x0p4400", "0"}, {"0e1100", "0"},     {"0e-1100", "0"},
  };
  for (const Case& c : cases) EXPECT_EQ(parse_number(c.token).get_str(), c.value) << c.token;
}

TEST(Number, RejectsEverythingElse) {
  const char* cases[] = {"",
                         "+",
                         "-",
                         ".",
                         "e5",
                         "1e",
                         "1e+",
                         "1e-",
                         "1.2.3",
                         "--1",
                         "+-1",
                         "1/",
                         "/2",
                         "1/-2",
                         "1/+2",
                         "1/2/3",
                         "1/2.0",
                         "1.0/2",
                         "1/2e3",
                         "0x",
                         "0x.",
                         "-0x",
                         "0xg",
                         "0x1p",
                         "0x1p+",
                         "0x1.8q2",
                         "0x1/2",
                         "1/0x2",
                         "1p3",
                         "0x1p0x1",
                         "1e1.5",
                         "inf",
                         "nan",
                         "NaN",
                         "-inf",
                         "1,5",
                         "1_000",
                         "0b1",
                         "1e5f",
                         "1.5L",
                         "x",
                         "1/0",
                         "0/0",
                         "1/00",
                         "1e1101",
                         "1e-1101",
                         "1e99999999999999999999",
                         "0e1101",
                         "0x1p4401",
                         "0x1p-4401",
                         "0x0p99999999999999999999",
                         "0X"};
  for (const char* token : cases) EXPECT_THROW((void)parse_number(token), std::invalid_argument) << token;
}

TEST(Number, ExponentLimitsAreReached) {
  EXPECT_EQ(parse_number("1e1100").get_str(), "1" + std::string(1100, '0'));
  EXPECT_EQ(parse_number("1e-1100").get_den().get_str(), "1" + std::string(1100, '0'));
  EXPECT_EQ(mpz_sizeinbase(parse_number("0x1p4400").get_num_mpz_t(), 2), 4401U);
  EXPECT_EQ(mpz_sizeinbase(parse_number("0x1p-4400").get_den_mpz_t(), 2), 4401U);
  EXPECT_EQ(parse_number("1e" + std::string(4000, '0') + "2"), 100);  // leading zeros do not count
}

TEST(Number, HexadecimalFractionsScaleByFourBits) {
  EXPECT_EQ(parse_number("0x1.8p-2"), Rational(3, 8));
  EXPECT_EQ(parse_number("0x0.01"), Rational(1, 256));
  EXPECT_EQ(parse_number("-0x1.fffffffffffffp1023"), -parse_number("0x1fffffffffffffp971"));
}

}  // namespace
}  // namespace flatdt::checker
