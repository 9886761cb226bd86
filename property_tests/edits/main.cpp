/// Edits of valid triangulations on all twelve manifolds, judged by the checker: the table of scripts/edits.
/// Exit code 0 only if every kind was tried, every edit that invalidates was refuted with the conditions that
/// must fail, and none of those that keep validity.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>

#include "bases.hpp"
#include "crafted.hpp"
#include "draft.hpp"
#include "flatdt/checker/check.hpp"
#include "flatdt/checker/errors.hpp"
#include "table.hpp"

namespace flatdt::edits {
namespace {

struct Options {
  std::size_t tries = 1;
  std::uint64_t seed = 1;
  bool quick = false;
  bool verbose = false;
  std::string corpus;  ///< folder of valid pairs
  std::string keep;    ///< folder for the pairs that are not as they must be
};

std::optional<checker::Verdict> judged(const Files& files) {
  std::istringstream instance_text(files.instance);
  std::istringstream triangulation_text(files.triangulation);
  try {
    const checker::Instance instance = checker::parse_instance(instance_text, "instance");
    return checker::check(instance,
                          checker::parse_triangulation(triangulation_text, "triangulation", instance));
  } catch (const checker::MalformedInput&) {
    return std::nullopt;
  }
}

void keep(const Options& options, const Kind& kind, std::size_t number, const Files& files) {
  if (options.keep.empty()) return;
  std::string stem = options.keep + "/" + std::to_string(number) + "-" + std::string(kind.name);
  for (std::size_t i = options.keep.size() + 1; i < stem.size(); ++i)
    if (stem[i] == ' ' || stem[i] == ',' || stem[i] == ':') stem[i] = '-';
  std::ofstream(stem + ".instance") << files.instance;
  std::ofstream(stem + ".triangulation") << files.triangulation;
}

/// All kinds of edit of some bases; counts what was said.
class Session {
 public:
  explicit Session(Options options) : options_(std::move(options)), rows_(kinds().size()) {}

  void edit_all(const Base& base) {
    edit_some(base, [](std::string_view) { return true; });
  }

  /// All kinds, or only those that it was made for.
  void edit_crafted(const Crafted& crafted) {
    edit_some(crafted.base, [&](std::string_view kind) {
      return !options_.quick || std::count(crafted.made_for.begin(), crafted.made_for.end(), kind) > 0;
    });
  }

  /// The table and the sums. Returns the exit code.
  int conclude(double seconds) const {
    print(std::cout, rows_);
    std::size_t never = 0;
    std::size_t tries = 0;
    for (const Row& row : rows_) {
      never += row.tries == 0 ? 1 : 0;
      tries += row.tries;
    }
    std::cout << "\n"
              << tries << " edits of " << kinds().size() << " kinds, of " << bases_
              << " valid triangulations (" << in_cover_ << " of them of covering spaces); " << wrong_
              << " wrong, " << never << " kinds never applied; seed " << options_.seed << "; " << seconds
              << " s\n";
    return wrong_ == 0 && never == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }

 private:
  /// The kinds that are wanted: a function of their names.
  template <class Wanted>
  void edit_some(const Base& base, const Wanted& wanted) {
    ++bases_;
    in_cover_ += base.on_manifold() ? 0 : 1;
    const std::optional<checker::Verdict> before = judged(Draft(base).files());
    if (!before || before->outcome != checker::Outcome::verified) {
      ++wrong_;
      std::cout << "WRONG: not verified before any edit: " << base.label() << std::endl;
      return;
    }
    for (std::size_t i = 0; i < kinds().size(); ++i) {
      if (!wanted(kinds()[i].name)) continue;
      const std::optional<Files> files = edit(kinds()[i], base, options_.seed);
      if (!files) continue;
      const std::string why = record(rows_[i], kinds()[i].expectation, judged(*files));
      if (why.empty()) continue;
      std::cout << "WRONG: " << kinds()[i].name << ": " << why << ": " << base.label() << std::endl;
      keep(options_, kinds()[i], wrong_++, *files);
    }
  }

  Options options_;
  std::vector<Row> rows_;
  std::size_t wrong_ = 0;
  std::size_t bases_ = 0;
  std::size_t in_cover_ = 0;
};

int run(const Options& options) {
  const std::clock_t begin = std::clock();
  const auto elapsed = [begin] {
    return static_cast<double>(std::clock() - begin) / static_cast<double>(CLOCKS_PER_SEC);
  };
  Session session(options);
  if (!options.corpus.empty())
    for (const Base& base : bases_of_folder(options.corpus, options.quick ? 30 : 600)) session.edit_all(base);
  for (const Crafted& crafted : crafted_bases()) session.edit_crafted(crafted);
  for (std::size_t round = 0; round < options.tries; ++round)
    for (const Recipe& recipe : recipes(options.quick, round, options.seed)) {
      const std::optional<Base> base = make_base(recipe);
      if (!base) continue;
      if (options.verbose)
        std::cerr << elapsed() << " s: " << base->label() << ", " << base->cell_count() << " cells\n";
      session.edit_all(*base);
    }
  return session.conclude(elapsed());
}

/// Every expectation must object to a verdict that denies it: all verified, nothing failing that must, a
/// parser that refuses or does not.
int self_test() {
  using checker::Outcome;
  using checker::Status;
  std::size_t deaf = 0;
  const auto must_object = [&](const Kind& kind, const std::optional<checker::Verdict>& verdict) {
    if (!contradiction(kind.expectation, verdict).empty()) return;
    ++deaf;
    std::cout << "self-test: no objection: " << kind.name << "\n";
  };
  checker::Verdict verified;
  verified.outcome = Outcome::verified;
  checker::Verdict unknown;
  for (checker::Condition& c : verified.conditions) c.status = Status::holds;
  for (const Kind& kind : kinds()) {
    must_object(kind, unknown);
    if (kind.expectation.effect == Expectation::Effect::keeps) {
      must_object(kind, std::nullopt);
      for (const Outcome outcome : {Outcome::refuted, Outcome::malformed}) {
        checker::Verdict verdict = verified;
        verdict.outcome = outcome;
        must_object(kind, verdict);
      }
      continue;
    }
    must_object(kind, verified);
    if (kind.expectation.effect == Expectation::Effect::unreadable) continue;
    must_object(kind, std::nullopt);
    // A verdict that is right, then each part of it denied.
    checker::Verdict right = verified;
    for (const checker::ConditionName name : kind.expectation.fail) right[name].status = Status::fails;
    for (const checker::ConditionName name : kind.expectation.one_of) right[name].status = Status::fails;
    for (const Outcome outcome : {Outcome::refuted, Outcome::malformed}) {
      right.outcome = outcome;
      if (contradiction(kind.expectation, right).empty()) break;
    }
    if (!contradiction(kind.expectation, right).empty()) {
      ++deaf;
      std::cout << "self-test: objects to a right verdict: " << kind.name << "\n";
    }
    for (const checker::ConditionName name : kind.expectation.fail) {
      checker::Verdict verdict = right;
      verdict[name].status = Status::holds;
      must_object(kind, verdict);
    }
    for (const checker::ConditionName name : kind.expectation.hold) {
      checker::Verdict verdict = right;
      verdict[name].status = Status::fails;
      must_object(kind, verdict);
    }
    if (kind.expectation.one_of.empty()) continue;
    checker::Verdict verdict = right;
    for (const checker::ConditionName name : kind.expectation.one_of) verdict[name].status = Status::holds;
    must_object(kind, verdict);
  }
  std::cout << "self-test: " << deaf << " faults\n";
  return deaf == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace flatdt::edits

int main(int argc, char** argv) {
  flatdt::edits::Options options;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--self-test") return flatdt::edits::self_test();
      if (word == "--quick") {
        options.quick = true;
        continue;
      }
      if (word == "--verbose") {
        options.verbose = true;
        continue;
      }
      if (i + 1 == argc) throw std::invalid_argument(word);
      if (word == "--tries")
        options.tries = std::stoul(argv[++i]);
      else if (word == "--seed")
        options.seed = std::stoull(argv[++i]);
      else if (word == "--corpus")
        options.corpus = argv[++i];
      else if (word == "--keep")
        options.keep = argv[++i];
      else
        throw std::invalid_argument(word);
    }
  } catch (const std::exception&) {
    std::cerr << "usage: edits [--tries N] [--seed S] [--quick] [--verbose] [--corpus FOLDER] [--keep "
                 "FOLDER] | --self-test\n";
    return 2;
  }
  return flatdt::edits::run(options);
}
