#include "report.hpp"

#include <cstdio>

namespace flatdt::campaign {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += (c >= ' ' && c <= '~') || c == '\n' || c == '\t' ? c : '?';
    }
  }
  return result;
}

std::string text_summary(const Options& options, const Ledger& ledger) {
  const Tally total = ledger.total();
  std::string text = std::to_string(total.cases()) + " cases: " + std::to_string(total.right) + " right, " +
                     std::to_string(total.wrong) + " wrong, " + std::to_string(total.unsupported) +
                     " unsupported\n";
  for (const Group& group : grouped(ledger.failures())) {
    const Result& first = group.failures.front();
    text += std::to_string(group.failures.size()) + " x " + group.signature + ": " + title(group) +
            (group.form.empty() ? ", for example case " + std::to_string(first.number) : "") +
            (first.bundle.empty() ? "" : ": " + options.out + "/" + first.bundle) + "\n";
  }
  return text;
}

std::string junit_report(const Options& options, const Ledger& ledger) {
  const std::vector<Group> groups = grouped(ledger.failures());
  const auto tallies = ledger.tallies();
  std::string cases;
  std::size_t failures = 0, skipped = 0;
  for (const auto& [key, tally] : tallies) {
    const auto& [manifold, family] = key;
    cases += "  <testcase classname=\"" + escaped(manifold) + "\" name=\"" + escaped(family) + "\">\n";
    bool failed = false;
    for (const Group& group : groups) {
      std::size_t here = 0;
      const Result* shown = nullptr;
      for (const Result& r : group.failures) {
        if (r.manifold != manifold || r.family != family) continue;
        ++here;
        if (shown == nullptr) shown = &r;
      }
      if (shown == nullptr) continue;
      // One failure element a test case is what most readers of the format take.
      if (!failed)
        cases += "    <failure message=\"" + escaped(group.signature) + "\">" + std::to_string(here) +
                 " of " + std::to_string(tally.cases()) + " cases; first case " +
                 std::to_string(shown->number) + "\n" + escaped(title(group)) + "\n" +
                 escaped(shown->bundle) + "\n" + escaped(shown->reason) + "</failure>\n";
      failed = true;
    }
    failures += failed ? 1 : 0;
    if (!failed && tally.right == 0) {
      cases += "    <skipped message=\"unsupported\"/>\n";
      ++skipped;
    }
    cases += "    <system-out>" + std::to_string(tally.right) + " right, " + std::to_string(tally.wrong) +
             " wrong, " + std::to_string(tally.unsupported) + " unsupported</system-out>\n  </testcase>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n <testsuite name=\"" +
         escaped(options.against) + "\" tests=\"" + std::to_string(tallies.size()) + "\" failures=\"" +
         std::to_string(failures) + "\" errors=\"0\" skipped=\"" + std::to_string(skipped) + "\">\n" + cases +
         " </testsuite>\n</testsuites>\n";
}

}  // namespace flatdt::campaign
