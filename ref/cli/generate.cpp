#include "commands.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "text_files.hpp"

namespace flatdt::ref::cli {
namespace {

std::string family_list() {
  std::string text;
  for (const Family& family : families())
    text += family.name + std::string(18 - family.name.size(), ' ') + family.description + "\n";
  return text;
}

}  // namespace

int run_generate(const GenerateOptions& options) {
  if (options.family == "list") {
    write_output(options.output, family_list());
    return 0;
  }
  if (options.manifold.empty()) throw InvalidInput("generate: --manifold NAME is required");
  const CatalogueEntry* entry = find_entry(options.manifold);
  if (entry == nullptr)
    throw InvalidInput("no manifold is called \"" + options.manifold.substr(0, 40) +
                       "\": `flatdt manifolds` lists the names");
  const Instance instance =
      generate(*entry, options.manifold, options.family, options.points, options.seed, options.metric);
  const std::string comment = "# family " + options.family + ", seed " + std::to_string(options.seed) +
                              ", metric " + options.metric + "\n";
  write_output(options.output, comment + write_instance(instance));
  return 0;
}

}  // namespace flatdt::ref::cli
