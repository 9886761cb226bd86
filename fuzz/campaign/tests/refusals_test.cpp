// What a capabilities file or a command line may not say is refused with what is wrong and what is right.
#include "fixture.hpp"
#include "numbers.hpp"

namespace flatdt::campaign {
namespace {

/// The message with which a file of this text is refused; empty if it is not.
std::string refusal_of_file(const std::string& text) {
  const Folder folder;
  const std::string path = folder.path() + "/c.json";
  write_text(path, text);
  try {
    static_cast<void>(read_capabilities(path));
    return {};
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).rfind(path + ": ", 0), 0U) << "the file is named: " << error.what();
    return std::string(error.what()).substr(path.size() + 2);
  }
}

std::string refusal_of_key(const std::string& member) {
  return refusal_of_file(R"({"schema": "flatdt-capabilities 1", )" + member + "}");
}

TEST(CapabilitiesFile, MustBeOne) {
  for (const char* wrong :
       {"", "[]", "{", R"({"manifolds": ["G1"]})", R"({"schema": "flatdt-capabilities 2"})",
        R"({"schema": 1})", "\"flatdt-capabilities 1\"", "\xff\xfe"})
    EXPECT_NE(refusal_of_file(wrong), "") << wrong;
  EXPECT_EQ(refusal_of_key(R"("colour": 1)"), R"(there is no key "colour")");
  EXPECT_THROW(static_cast<void>(read_capabilities("/no/such/file")), std::runtime_error);
}

struct Refused {
  const char* member;
  const char* message;
};

constexpr Refused kRefused[] = {
    {R"("max_points": 5)",
     R"("max_points" must be numbers for the dimensions, as in {"2": 1000, "3": 200}, not 5)"},
    {R"("max_points": {"2": -5})", R"("max_points" "2" must be a whole number from 1 to 1000000, not -5)"},
    {R"("max_points": {"3": 0})", R"("max_points" "3" must be a whole number from 1 to 1000000, not 0)"},
    {R"("max_points": {"3": 2.5})", R"("max_points" "3" must be a whole number from 1 to 1000000, not 2.5)"},
    {R"("max_points": {"3": "10"})",
     R"("max_points" "3" must be a whole number from 1 to 1000000, not "10")"},
    {R"("max_points": {"4": 10})", R"(a key of "max_points" must be "2" or "3", not "4")"},
    {R"("max_points": {"2": 3}, "min_points": 4)",
     R"("max_points" "2" must be at least "min_points", which is 4, not 3)"},
    {R"("min_points": -1)", R"("min_points" must be a whole number from 1 to 1000000, not -1)"},
    {R"("min_points": 18446744073709551616)", R"("min_points" must be a whole number from 1 to 1000000)"},
    {R"("facet_resolution_bits": 64)",
     R"("facet_resolution_bits" must be a whole number from 0 to 62, not 64)"},
    {R"("facet_resolution_bits": -1)",
     R"("facet_resolution_bits" must be a whole number from 0 to 62, not -1)"},
    {R"("unsupported_exit": 4294967300)",
     R"("unsupported_exit" must be a whole number from 1 to 255, not 4294967300)"},
    {R"("unsupported_exit": 0)", R"("unsupported_exit" must be a whole number from 1 to 255, not 0)"},
    {R"("unsupported_exit": "4")", R"("unsupported_exit" must be a whole number from 1 to 255, not "4")"},
    {R"("distinct": 1)", R"("distinct" must be true or false, not 1)"},
    {R"("metrics": "euclidean")", R"("metrics" must be "canonical" or "any", not "euclidean")"},
    {R"("metrics": true)", R"("metrics" must be "canonical" or "any", not true)"},
    {R"("coordinates": null)", R"("coordinates" must be "doubles" or "any", not null)"},
    {R"("generators": "matrices")", R"("generators" must be "names" or "any", not "matrices")"},
    {R"("claims": "cells")", R"("claims" must be "edges" or "triangulation", not "cells")"},
    {R"("manifolds": "G1")", R"("manifolds" must be a list of one or more names of manifolds, not "G1")"},
    {R"("manifolds": [])", R"("manifolds" must be a list of one or more names of manifolds, not [])"},
    {R"("manifolds": ["G1", "G7"])", R"(names that `flatdt manifolds` prints, not "G7")"},
};

TEST(CapabilitiesFile, RefusalsNameKeyValueAndWhatIsRight) {
  for (const Refused& c : kRefused)
    EXPECT_NE(refusal_of_key(c.member).find(c.message), std::string::npos) << c.member << "\n"
                                                                           << refusal_of_key(c.member);
}

TEST(CapabilitiesFile, BoundsAreAccepted) {
  for (const char* right :
       {R"("facet_resolution_bits": 0)", R"("facet_resolution_bits": 62)", R"("unsupported_exit": 1)",
        R"("unsupported_exit": 255)", R"("min_points": 1)", R"("max_points": {"2": 1, "3": 1000000})",
        R"("max_points": {})", R"("comment": 7)"})
    EXPECT_EQ(refusal_of_key(right), "") << right;
}

TEST(Options, DurationsHaveUnits) {
  EXPECT_EQ(parse_duration("90"), 90);
  EXPECT_EQ(parse_duration("1.5h"), 5400);
  EXPECT_EQ(parse_duration("10m"), 600);
  for (const char* wrong :
       {"", "m", "10 days", "-1", "inf", "nan", "0x10", "1e3", "1.", ".5", " 5", "99999h"})
    EXPECT_THROW(static_cast<void>(parse_duration(wrong)), UsageError) << wrong;
}

/// The message with which a command line is refused; empty if it is not.
std::string refusal(std::vector<std::string> words) {
  words.insert(words.begin(), {"flatdt-campaign", "--against", "true"});
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  try {
    static_cast<void>(parse_options(static_cast<int>(argv.size()), argv.data()));
    return {};
  } catch (const UsageError& error) {
    return error.what();
  }
}

void expect_refused(const char* option, const char* value, const std::string& right) {
  const std::string message = refusal({option, value});
  EXPECT_NE(message.find(option + right), std::string::npos) << option << " " << value << ": " << message;
}

TEST(Options, NumbersThatAreNoneAreRefused) {
  for (const char* option : {"--time-limit", "--wall-limit", "--memory-limit", "--address-limit",
                             "--output-limit", "--minimise-time"}) {
    for (const char* wrong :
         {"nan", "inf", "-1", "-0", "1e3", "0x10", "5s", "", "99999999", "1e999", "+1", "1,5"})
      expect_refused(option, wrong, " must be a number from 0 to ");
    for (const char* right : {"0", "0.5", "3", "007"}) EXPECT_EQ(refusal({option, right}), "") << option;
  }
  for (const char* option : {"--seed", "--cases", "--only", "--jobs", "--minimise-each", "--minimise-runs"}) {
    for (const char* wrong : {"-1", "18446744073709551616", "99999999999999999999999", "1.5", "x", "", "+1"})
      expect_refused(option, wrong, " must be a whole number from 0 to ");
    EXPECT_EQ(refusal({option, "7"}), "") << option;
  }
  for (const char* option : {"--seed", "--cases", "--only"})
    EXPECT_EQ(refusal({option, "18446744073709551615"}), "") << option;
  EXPECT_NE(refusal({"--jobs", "257"}), "");
}

TEST(Options, RangesAndPartsThatAreNoneAreRefused) {
  for (const char* wrong : {"9..1", "0..5", "1..", "..5", "1..2..3", "-1..5", "1..1000001", "a"})
    EXPECT_NE(refusal({"--points", wrong}), "") << wrong;
  for (const char* wrong : {"3/2", "0/2", "1", "1/0", "/", "1/-1", "1/1000001", ""})
    EXPECT_NE(refusal({"--shard", wrong}), "") << wrong;
}

TEST(Options, SmallLimitsStayLimits) {
  const std::vector<const char*> argv{"flatdt-campaign", "--against", "true", "--memory-limit",
                                      "0.0000000001"};
  const auto options = parse_options(static_cast<int>(argv.size()), argv.data());
  ASSERT_TRUE(options);
  EXPECT_EQ(options->contact.limits.memory_bytes, 1U) << "0 would be no limit";
}

}  // namespace
}  // namespace flatdt::campaign
