#include "structured_target.hpp"

#include "../engine/target.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::fuzz {
namespace {

/// Query points have no file of their own: they are comments of the instance.
std::string query_comments(const Specimen& specimen) {
  std::string text;
  for (const CodedQuery& query : specimen.queries) {
    text += "# query point: element coset " + std::to_string(query.coset) + " shift";
    for (int i = 0; i < specimen.dimension(); ++i)
      text += " " + std::to_string(query.shift[static_cast<std::size_t>(i)]);
    text += " of point " + std::to_string(query.point) + "\n";
  }
  return text;
}

/// Files name no query points: an even spread of them, to start from.
void add_queries(Specimen& specimen) {
  for (int k = 0; k < 12; ++k) {
    CodedQuery query;
    query.point = static_cast<std::uint8_t>(static_cast<std::size_t>(k) % specimen.points.size());
    query.coset = static_cast<std::uint8_t>(k);
    for (std::size_t i = 0; i < 3; ++i) query.shift[i] = static_cast<std::int8_t>((k >> i) & 1);
    specimen.queries.push_back(query);
  }
}

}  // namespace

Texts texts_of(const Specimen& specimen) {
  Texts texts{ref::write_instance(instance_of(specimen)), {}};
  if (kShape.triangulation) texts.triangulation = ref::write_triangulation(triangulation_of(specimen), {});
  return texts;
}

std::vector<File> print(std::span<const std::uint8_t> bytes) {
  const Specimen specimen = decode(bytes, kShape);
  const Texts texts = texts_of(specimen);
  std::vector<File> files = {{"instance", texts.instance + query_comments(specimen)}};
  if (kShape.triangulation) files.push_back({"triangulation", texts.triangulation});
  return files;
}

std::optional<Bytes> encode(const std::vector<std::string>& texts) {
  if (texts.empty() || texts.size() > (kShape.triangulation ? 2U : 1U)) return std::nullopt;
  try {
    const ref::Instance instance = ref::parse_instance(texts[0], "instance");
    std::optional<Specimen> specimen = specimen_of(instance);
    if (!specimen) return std::nullopt;
    if (texts.size() == 2 &&
        !set_triangulation(*specimen, ref::parse_triangulation(texts[1], "triangulation", instance.dimension,
                                                               instance.points.size())))
      return std::nullopt;
    if (kShape.queries) add_queries(*specimen);
    return encode(*specimen, kShape);
  } catch (const ref::InvalidInput&) {
    return std::nullopt;
  }
}

}  // namespace flatdt::fuzz
