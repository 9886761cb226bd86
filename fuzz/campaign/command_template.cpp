#include "command_template.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string_view>

namespace flatdt::campaign {
namespace {

constexpr std::string_view kInstance = "{instance}";
constexpr std::string_view kOutput = "{output}";

void replace_all(std::string& word, const std::string& place, const std::string& by) {
  for (std::size_t at = word.find(place); at != std::string::npos; at = word.find(place, at + by.size()))
    word.replace(at, place.size(), by);
}

}  // namespace

std::vector<std::string> split_command(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  bool in_word = false;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0 && c == quote) {
      quote = 0;
    } else if (c == '\\' && quote != '\'' && i + 1 < text.size()) {
      word += text[++i];
      in_word = true;
    } else if (quote != 0) {
      word += c;
    } else if (c == '\'' || c == '"') {
      quote = c;
      in_word = true;
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      if (in_word) words.push_back(word);
      word.clear();
      in_word = false;
    } else {
      word += c;
      in_word = true;
    }
  }
  if (quote != 0) throw std::invalid_argument(std::string("the command has an open ") + quote);
  if (in_word) words.push_back(word);
  if (words.empty()) throw std::invalid_argument("the command is empty");
  return words;
}

bool has_place(const std::vector<std::string>& words, const std::string& place) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& w) { return w.find("{" + place + "}") != std::string::npos; });
}

std::vector<std::string> filled(std::vector<std::string> words, const std::string& instance,
                                const std::string& output) {
  for (std::string& word : words) {
    replace_all(word, std::string(kInstance), instance);
    replace_all(word, std::string(kOutput), output);
  }
  return words;
}

std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("/._-+=:,@%").find(static_cast<char>(c)) != std::string::npos;
  });
  if (plain) return word;
  std::string quoted = word;
  replace_all(quoted, "'", "'\\''");
  return "'" + quoted + "'";
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

std::string shell_line(const std::vector<std::string>& words, const std::string& instance,
                       const std::string& output) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    std::string piece;  // between places
    const auto finish = [&] {
      if (!piece.empty()) line += shell_word(piece);
      piece.clear();
    };
    for (std::size_t at = 0; at < word.size();) {
      const std::string_view rest = std::string_view(word).substr(at);
      const std::string_view place = rest.starts_with(kInstance) ? kInstance
                                     : rest.starts_with(kOutput) ? kOutput
                                                                 : std::string_view();
      if (place.empty()) {
        piece += word[at++];
        continue;
      }
      finish();
      line += place == kInstance ? instance : output;
      at += place.size();
    }
    if (word.empty()) line += "''";
    finish();
  }
  return line;
}

}  // namespace flatdt::campaign
