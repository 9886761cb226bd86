#include <cstdint>

#include "report.hpp"
#include "text_file.hpp"

namespace flatdt::campaign {
namespace {

constexpr std::size_t kMostShown = 20000;  // bytes of one file

constexpr const char* kStyle =
    "body{font:15px/1.45 system-ui,sans-serif;max-width:70em;margin:2em auto;padding:0 "
    "1em;color:#222;background:#fff}"
    "table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.2em .6em;text-align:right}"
    "th:first-child,td:first-child{text-align:left}pre{background:#f3f3f3;padding:.7em;overflow:auto;max-"
    "height:30em}"
    ".wrong{background:#f8d0cc}.none{color:#777}section{border-top:2px solid #888;margin-top:2em}"
    "img,iframe{max-width:100%;border:1px solid #bbb;background:#fff}iframe{width:100%;height:32em}"
    "@media(prefers-color-scheme:dark){body{color:#ddd;background:#1b1b1b}pre{background:#2a2a2a}"
    ".wrong{background:#7a2a24}}";

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      group =
          group << 8 | (k < n ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= n ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string shown_file(const std::string& title, const std::string& path) {
  std::string text = read_text(path);
  if (text.empty()) return {};
  if (text.size() > kMostShown)
    text = text.substr(0, kMostShown) + "\n... (" + std::to_string(text.size()) + " bytes)";
  return "<details><summary>" + title + "</summary><pre>" + escaped(text) + "</pre></details>\n";
}

std::string picture(const std::string& folder) {
  const std::string svg = read_text(folder + "/picture.svg");
  if (!svg.empty())
    return "<img alt=\"the output for the shrunk case\" src=\"data:image/svg+xml;base64," + base64(svg) +
           "\">\n";
  const std::string page = read_text(folder + "/picture.html");
  if (!page.empty())
    return "<iframe loading=\"lazy\" title=\"the output\" srcdoc=\"" + escaped(page) + "\"></iframe>\n";
  return {};
}

std::string group_section(const Options& options, const Group& group, std::size_t number) {
  const Result& first = group.failures.front();
  std::string html = "<section><h2>" + std::to_string(number) + ". " + escaped(group.signature) +
                     "</h2>\n<p>" + std::to_string(group.failures.size()) + " failures. " +
                     (group.form.empty() ? "Not minimised." : "Shrunk to: " + escaped(title(group)) + ".");
  if (!first.bundle.empty())
    html += first.finished ? " Nothing simpler was found to fail in the same way."
                           : " The budget ended before that was minimal.";
  html += "</p>\n<p>Cases:";
  for (std::size_t i = 0; i < group.failures.size() && i < 20; ++i)
    html += " " + std::to_string(group.failures[i].number);
  html += group.failures.size() > 20 ? " ...</p>\n" : "</p>\n";
  if (!first.reason.empty()) html += "<pre>" + escaped(first.reason) + "</pre>\n";
  if (first.bundle.empty()) return html + "</section>\n";
  const std::string folder = options.out + "/" + first.bundle;
  html += picture(folder) + "<p>Bundle: <code>" + escaped(first.bundle) +
          "</code>. To see it again: <code>sh " + escaped(first.bundle) + "/reproduce</code></p>\n<pre>" +
          escaped(read_text(folder + "/instance")) + "</pre>\n";
  html += shown_file("output", folder + "/output") + shown_file("verdict", folder + "/verdict.json") +
          shown_file("the case as drawn", folder + "/original.instance") +
          shown_file("script", folder + "/reproduce");
  return html + "</section>\n";
}

}  // namespace

std::string html_report(const Options& options, const Ledger& ledger) {
  const Tally total = ledger.total();
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>flatdt-campaign: " +
      escaped(options.against) + "</title><style>" + kStyle +
      "</style></head><body>\n<h1>Campaign against <code>" + escaped(options.against) + "</code></h1>\n<p>" +
      std::to_string(total.cases()) + " cases: " + std::to_string(total.right) + " right, <b>" +
      std::to_string(total.wrong) + " wrong</b>, " + std::to_string(total.unsupported) +
      " unsupported. Seed " + std::to_string(options.plan.seed) + ", shard " + std::to_string(options.shard) +
      "/" + std::to_string(options.shards) + ", points " + std::to_string(options.plan.min_points) + " to " +
      std::to_string(options.plan.max_points) + ".</p>\n";
  std::string sections;
  std::size_t number = 0;
  html += "<ol>\n";
  for (const Group& group : grouped(ledger.failures())) {
    html += "<li>" + std::to_string(group.failures.size()) + " &times; " + escaped(group.signature) + ": " +
            escaped(title(group)) + "</li>\n";
    sections += group_section(options, group, ++number);
  }
  html +=
      "</ol>\n<table><tr><th>manifold</th><th>family</th><th>right</th><th>wrong</th><th>unsupported</th></"
      "tr>\n";
  for (const auto& [key, tally] : ledger.tallies())
    html += std::string("<tr") + (tally.wrong > 0 ? " class=\"wrong\"" : "") + "><td>" + escaped(key.first) +
            "</td><td>" + escaped(key.second) + "</td><td>" + std::to_string(tally.right) + "</td><td>" +
            std::to_string(tally.wrong) + "</td><td>" + std::to_string(tally.unsupported) + "</td></tr>\n";
  return html + "</table>\n" + sections + "</body></html>\n";
}

}  // namespace flatdt::campaign
