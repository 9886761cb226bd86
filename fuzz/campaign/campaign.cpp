#include "campaign.hpp"

#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>

#include "bundle.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "progress.hpp"

namespace flatdt::campaign {
namespace {

using Clock = std::chrono::steady_clock;
using testing::Specimen;

std::string instance_text(const Specimen& specimen) {
  return ref::write_instance(testing::instance_of(specimen));
}

/// One thread's part.
class Worker {
 public:
  Worker(const Options& options, Ledger& ledger, unsigned job)
      : options_(options),
        ledger_(ledger),
        folder_(options.out + "/work/" + std::to_string(job)),
        implementation_(
            (std::filesystem::create_directories(folder_), make_implementation(options.contact, folder_))) {}

  void run(std::uint64_t number) {
    const Clock::time_point start = Clock::now();
    const Specimen specimen = draw_case(options_.plan, number);
    Result result;
    result.number = number;
    result.manifold = testing::name_of(specimen);
    result.family = specimen.family;
    result.points = specimen.points.size();
    const Trial trial = try_out(specimen);
    result.outcome = trial.judgement.worth == Worth::right         ? "right"
                     : trial.judgement.worth == Worth::unsupported ? "unsupported"
                                                                   : "wrong";
    if (trial.judgement.worth == Worth::wrong) {
      result.signature = trial.judgement.signature;
      result.reason = trial.judgement.reason;
      if (ledger_.is_among_first(result.signature, options_.minimise_each)) shrink(specimen, result);
    }
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    ledger_.add(result);
  }

 private:
  struct Trial {
    Answer answer;
    Judgement judgement;
  };

  Trial try_out(const Specimen& specimen) {
    if (specimen.points.empty() || !accepts(options_.plan.capabilities, specimen))
      return {{}, {Worth::unsupported, {}, {}, {}}};
    const std::string instance = instance_text(specimen);
    Trial trial{implementation_->answer(instance), {}};
    trial.judgement = judge(instance, trial.answer, options_.plan.capabilities);
    return trial;
  }

  void shrink(const Specimen& specimen, Result& result) {
    Trial last;
    Specimen shown = specimen;
    const auto fails = [&](const Specimen& candidate) {
      Trial trial = try_out(candidate);
      if (trial.judgement.worth != Worth::wrong || trial.judgement.signature != result.signature)
        return false;
      last = std::move(trial);
      return true;
    };
    std::string note;
    if (fails(specimen)) {
      const Shrunk shrunk = minimise(specimen, options_.plan, options_.budget, fails);
      shown = shrunk.specimen;
      result.finished = shrunk.finished;
      result.form = form_of(shown);
      result.shrunk_points = shown.points.size();
    } else {
      result.form = "not seen again when it was repeated";
      last = try_out(specimen);
    }
    result.bundle = "findings/case-" + std::to_string(result.number);
    const std::string origin = "case " + std::to_string(result.number) + " of seed " +
                               std::to_string(options_.plan.seed) + ": " + result.manifold + ", " +
                               result.family;
    write_bundle(options_.out + "/" + result.bundle,
                 {instance_text(specimen), instance_text(shown), shown.dimension(), last.answer,
                  last.judgement, origin},
                 options_.contact, options_.plan.capabilities.claim, options_.flatdt);
  }

  const Options& options_;
  Ledger& ledger_;
  std::string folder_;
  std::unique_ptr<Implementation> implementation_;
};

/// Gives out case numbers, each once.
class Queue {
 public:
  Queue(const Options& options, const Ledger& ledger, const std::atomic<bool>& stop)
      : options_(options), ledger_(ledger), stop_(stop), next_(options.only.value_or(options.shard - 1)) {}

  std::optional<std::uint64_t> take() {
    for (;;) {
      const std::chrono::duration<double> spent = Clock::now() - start_;
      if (stop_ || (options_.seconds && spent.count() > *options_.seconds)) return std::nullopt;
      const std::uint64_t number = next_.fetch_add(options_.only ? 1 : options_.shards);
      if (options_.only ? number != *options_.only : options_.cases && number >= *options_.cases)
        return std::nullopt;
      if (!ledger_.has(number)) return number;
    }
  }

 private:
  const Options& options_;
  const Ledger& ledger_;
  const std::atomic<bool>& stop_;
  std::atomic<std::uint64_t> next_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

std::string form_of(const Specimen& s) {
  std::string form = testing::name_of(s);
  if (s.gram != s.entry->canonical_gram) form += ", another metric";
  if (!s.coordinates.is_identity()) form += ", other coordinates";
  if (s.naming != testing::Naming::name_only) form += ", with generators";
  return form;
}

void run_campaign(const Options& options, Ledger& ledger, const std::atomic<bool>& stop) {
  std::atomic<bool> halt = false;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  Queue queue(options, ledger, halt);
  const auto work = [&](unsigned job) {
    try {
      Worker worker(options, ledger, job);
      while (const auto number = queue.take()) worker.run(*number);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      halt = true;
    }
  };
  std::atomic<unsigned> running = 0;
  std::vector<std::thread> threads;
  try {
    for (unsigned job = 0; job < options.jobs; ++job) {
      ++running;
      threads.emplace_back([&, job] {
        work(job);
        --running;
      });
    }
  } catch (...) {  // no thread, or no memory for one: those that run must end first
    halt = true;
    for (std::thread& thread : threads) thread.join();
    throw;
  }
  Progress progress(options, ledger);
  while (running > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (stop) halt = true;
    progress.show();
  }
  for (std::thread& thread : threads) thread.join();
  progress.finish();
  std::filesystem::remove_all(options.out + "/work");
  if (failure) std::rethrow_exception(failure);
}

}  // namespace flatdt::campaign
