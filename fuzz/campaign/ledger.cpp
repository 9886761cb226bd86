#include "ledger.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "text_file.hpp"

namespace flatdt::campaign {
namespace {

std::string line_of(const Result& r) {
  nlohmann::ordered_json line = {{"case", r.number},   {"manifold", r.manifold}, {"family", r.family},
                                 {"points", r.points}, {"outcome", r.outcome},   {"seconds", r.seconds}};
  if (r.outcome == "wrong") {
    line["signature"] = r.signature;
    line["reason"] = r.reason;
    if (!r.bundle.empty()) {
      line["form"] = r.form;
      line["shrunk_points"] = r.shrunk_points;
      line["bundle"] = r.bundle;
      line["minimal"] = r.finished;
    }
  }
  // What a program prints need not be UTF-8.
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

Result result_of(const nlohmann::json& line) {
  Result r;
  r.number = line.at("case").get<std::uint64_t>();
  r.manifold = line.at("manifold").get<std::string>();
  r.family = line.at("family").get<std::string>();
  r.points = line.at("points").get<std::size_t>();
  r.outcome = line.at("outcome").get<std::string>();
  r.seconds = line.at("seconds").get<double>();
  r.signature = line.value("signature", "");
  r.reason = line.value("reason", "");
  r.form = line.value("form", "");
  r.shrunk_points = line.value("shrunk_points", std::size_t{0});
  r.bundle = line.value("bundle", "");
  r.finished = line.value("minimal", false);
  return r;
}

}  // namespace

Ledger::Ledger(const std::string& folder, const std::string& description, bool resume) {
  const std::string path = folder + "/results.jsonl";
  const bool known = std::filesystem::exists(path) && std::filesystem::file_size(path) > 0;
  if (known && !resume)
    throw std::runtime_error(folder + " has results already: give --resume, or another folder with --out");
  if (known) read(path, description);
  file_ = std::fopen(path.c_str(), "ae");
  if (file_ == nullptr) throw std::runtime_error("cannot write " + path);
  if (!known && (std::fputs((description + "\n").c_str(), file_) < 0 || std::fflush(file_) != 0))
    throw std::runtime_error("cannot write " + path);
}

Ledger::~Ledger() {
  if (file_ != nullptr) std::fclose(file_);
}

void Ledger::read(const std::string& path, const std::string& description) {
  const std::string text = read_text(path);
  const std::size_t whole = text.rfind('\n') + 1;  // what follows was cut short
  std::size_t at = text.find('\n');
  if (at == std::string::npos || text.substr(0, at) != description)
    throw std::runtime_error(path + " is of another campaign: its first line is not " + description);
  std::filesystem::resize_file(path, whole);
  for (++at; at < whole;) {
    const std::size_t end = text.find('\n', at);
    try {
      const Result result = result_of(nlohmann::json::parse(text.substr(at, end - at)));
      if (result.outcome == "wrong") ++seen_[result.signature];
      count(result);
      ++resumed_;
    } catch (const nlohmann::json::exception& error) {
      throw std::runtime_error(path + ": " + error.what());
    }
    at = end + 1;
  }
}

void Ledger::count(const Result& result) {
  if (!done_.insert(result.number).second) return;
  for (Tally* tally : {&total_, &tallies_[{result.manifold, result.family}]}) {
    tally->right += result.outcome == "right" ? 1 : 0;
    tally->unsupported += result.outcome == "unsupported" ? 1 : 0;
    tally->wrong += result.outcome == "wrong" ? 1 : 0;
  }
  if (result.outcome == "wrong") failures_.push_back(result);
}

void Ledger::add(const Result& result) {
  const std::string line = line_of(result);
  const std::lock_guard lock(mutex_);
  if (std::fputs(line.c_str(), file_) < 0 || std::fflush(file_) != 0)
    throw std::runtime_error("cannot write results.jsonl");
  count(result);
}

bool Ledger::has(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  return done_.contains(number);
}

bool Ledger::is_among_first(const std::string& signature, std::size_t most) {
  const std::lock_guard lock(mutex_);
  return ++seen_[signature] <= most;
}

Tally Ledger::total() const {
  const std::lock_guard lock(mutex_);
  return total_;
}

std::map<std::pair<std::string, std::string>, Tally> Ledger::tallies() const {
  const std::lock_guard lock(mutex_);
  return tallies_;
}

std::vector<Result> Ledger::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_;
}

}  // namespace flatdt::campaign
