/// The reports of a campaign.
#pragma once

#include <string>

#include "ledger.hpp"
#include "options.hpp"

namespace flatdt::campaign {

/// For people: counts, and one line for each group of failures.
[[nodiscard]] std::string text_summary(const Options& options, const Ledger& ledger);
/// JUnit XML: a test case for each manifold and family, a failure for each group of failures in it.
[[nodiscard]] std::string junit_report(const Options& options, const Ledger& ledger);
/// One HTML page that needs no other file: counts, and for each group its shrunk case with its picture.
[[nodiscard]] std::string html_report(const Options& options, const Ledger& ledger);

/// Text for XML and HTML; bytes that these cannot hold become question marks.
[[nodiscard]] std::string escaped(const std::string& text);

}  // namespace flatdt::campaign
