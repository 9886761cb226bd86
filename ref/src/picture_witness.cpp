#include "picture_witness.hpp"

namespace flatdt::ref::picture {
namespace {

std::string sentence_of(const Verdict& verdict, const Witness& witness) {
  return verdict.word + ": " + witness.sentence + " [" + witness.condition + "].";
}

}  // namespace

std::vector<Witness> witnesses_of(const Instance& instance, const Triangulation& triangulation,
                                  const WitnessChoice& choice, const PictureGroup& full,
                                  const ShownGroup& shown, std::vector<std::string>& notes) {
  std::vector<Witness> list;
  const auto show = [&](std::optional<Witness> found, const char* else_note) {
    notes.push_back(found ? found->sentence : else_note);
    if (found) list.push_back(std::move(*found));
  };
  if (choice.violation)
    show(find_violation(instance, triangulation, full), "No circumdisk has a point strictly inside.");
  if (choice.two_cycle)
    show(find_cycle(instance, triangulation, full),
         "The quotient by the group has neither a loop nor a 2-cycle.");
  if (!choice.verdict) return list;
  std::optional<Witness> chosen = chosen_witness(*choice.verdict, choice.condition, instance, triangulation);
  if (!chosen) {
    notes.push_back(choice.verdict->word + ": no condition fails.");
    return list;
  }
  if (chosen->condition == "facets.paired" && shown.has_copies)
    add_cells_at_facet(*chosen, instance, triangulation, shown.group);
  notes.push_back(sentence_of(*choice.verdict, *chosen));
  std::string others;
  for (const FailedCondition& failed : choice.verdict->failed)
    if (failed.name != chosen->condition) others += (others.empty() ? "" : ", ") + failed.name;
  if (!others.empty()) notes.push_back("These fail too: " + others + ".");
  notes.insert(notes.end(), chosen->notes.begin(), chosen->notes.end());
  list.push_back(std::move(*chosen));
  return list;
}

}  // namespace flatdt::ref::picture
