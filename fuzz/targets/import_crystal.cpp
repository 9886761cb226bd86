/// Texts as crystal structure files (CIF, mmCIF, PDB, gzip): the first byte chooses the options, the rest is
/// the file. What is imported is an instance that both sides read and whose group both admit.
#include <stdexcept>

#include "../../ref/cli/commands.hpp"
#include "../engine/expect.hpp"
#include "../engine/target.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "judged.hpp"

namespace flatdt::fuzz {
namespace {

ref::cli::ImportOptions options_of(std::span<const std::uint8_t> bytes) {
  const int first = bytes.empty() ? 0 : bytes[0];
  ref::cli::ImportOptions options;
  options.file = "f";
  if ((first & 1) != 0) options.coincident = "merge";
  if ((first & 2) != 0) options.altloc = "all";
  return options;
}

std::string text_of(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? std::string() : std::string(bytes.begin() + 1, bytes.end());
}

void expect_admitted(const std::string& text) {
  const ref::Instance instance = ref::parse_instance(text, "instance");
  static_cast<void>(ref::analyse(instance));
  const auto read = read_instance(text);
  expect(read.has_value(), "the checker reads what is imported");
  checker::Triangulation nothing;
  nothing.dimension = 3;
  if (const auto verdict = judge(*read, nothing))
    expect((*verdict)[checker::ConditionName::group_torsion_free].status == checker::Status::holds,
           "the checker admits the group of what is imported");
}

}  // namespace

std::vector<File> print(std::span<const std::uint8_t> bytes) {
  const auto options = options_of(bytes);
  const std::string text = text_of(bytes);
  return {{"options", "--coincident " + options.coincident + " --altloc " + options.altloc + "\n"},
          {text.rfind("data_", 0) == 0 ? "cif" : "pdb", text}};
}

/// A structure file, with the options' defaults.
std::optional<Bytes> encode(const std::vector<std::string>& texts) {
  if (texts.size() != 1) return std::nullopt;
  Bytes bytes = {0};
  bytes.insert(bytes.end(), texts[0].begin(), texts[0].end());
  return bytes;
}

}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt;
  std::string text;
  try {
    text = ref::cli::import_text(fuzz::text_of({data, size}), fuzz::options_of({data, size}));
  } catch (const ref::InvalidInput&) {
    return 0;
  } catch (const ref::LimitReached&) {
    return 0;
  }
  fuzz::expect_admitted(text);
  return 0;
}
