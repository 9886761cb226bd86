#include "finding.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace flatdt::campaign {

std::string title(const Group& group) {
  if (group.form.empty()) return "not minimised";
  const std::size_t least = group.failures.front().shrunk_points;
  if (least == 0) return group.form;
  const bool more = std::any_of(group.failures.begin(), group.failures.end(), [&](const Result& r) {
    return !r.bundle.empty() && r.shrunk_points != least;
  });
  return group.form + ", " + std::to_string(least) + (least == 1 ? " point" : " points") +
         (more ? " or more" : "");
}

namespace {

/// The parts of a form, between commas.
std::set<std::string> parts_of(const std::string& form) {
  std::set<std::string> parts;
  for (std::size_t at = 0; at != std::string::npos;) {
    const std::size_t end = form.find(", ", at);
    parts.insert(form.substr(at, end - at));
    at = end == std::string::npos ? end : end + 2;
  }
  return parts;
}

/// Of the forms that one signature has, the simplest whose parts all are in `form`: a case with other
/// coordinates, too, is a local minimum of the defect that needs none.
std::string simplest(const std::string& form, const std::vector<std::string>& forms) {
  const std::set<std::string> parts = parts_of(form);
  std::string best = form;
  for (const std::string& other : forms) {
    const std::set<std::string> fewer = parts_of(other);
    if (fewer.size() < parts_of(best).size() &&
        std::includes(parts.begin(), parts.end(), fewer.begin(), fewer.end()))
      best = other;
  }
  return best;
}

/// The form that a failure is counted with that was not minimised itself: the only one, or that of its
/// manifold.
std::string likely_form(const Result& failure, const std::vector<std::string>& forms) {
  if (forms.size() == 1) return forms.front();
  return std::find(forms.begin(), forms.end(), failure.manifold) != forms.end() ? failure.manifold
                                                                                : std::string();
}

}  // namespace

std::vector<Group> grouped(std::vector<Result> failures) {
  std::sort(failures.begin(), failures.end(),
            [](const Result& a, const Result& b) { return a.number < b.number; });
  std::map<std::string, std::vector<std::string>> seen, forms;  // of each signature: all, and the simplest
  for (const Result& f : failures)
    if (!f.form.empty()) seen[f.signature].push_back(f.form);
  for (const auto& [signature, all] : seen)
    for (const std::string& form : all) {
      auto& kept = forms[signature];
      const std::string simple = simplest(form, all);
      if (std::find(kept.begin(), kept.end(), simple) == kept.end()) kept.push_back(simple);
    }
  std::vector<Group> groups;
  for (Result& f : failures) {
    const auto& known = forms[f.signature];
    const std::string form = f.form.empty() ? likely_form(f, known) : simplest(f.form, known);
    const auto at = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
      return g.signature == f.signature && g.form == form;
    });
    Group& group = at != groups.end() ? *at : groups.emplace_back(Group{f.signature, form, {}});
    group.failures.push_back(std::move(f));
  }
  // A bundle of the group's own form stands first, of those the one with the fewest points, then the first.
  for (Group& g : groups)
    std::sort(g.failures.begin(), g.failures.end(), [&](const Result& x, const Result& y) {
      return std::tuple(x.bundle.empty(), x.form != g.form, x.shrunk_points, x.number) <
             std::tuple(y.bundle.empty(), y.form != g.form, y.shrunk_points, y.number);
    });
  return groups;
}

}  // namespace flatdt::campaign
