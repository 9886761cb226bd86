/// Symmetry operations: text, groups modulo the translations of the cell, agreement with the symbol.
#include <algorithm>
#include <cctype>
#include <set>

#include "crystal.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

constexpr std::size_t kMaxOperations = 192;

[[noreturn]] void fail_operation(std::string_view text, const std::string& reason) {
  throw InvalidInput("symmetry operation \"" + std::string(text.substr(0, 60)) + "\": " + reason);
}

/// A number at the front of `rest`, removed from it: digits with a point or a fraction.
Rational leading_number(std::string_view& rest, std::string_view whole) {
  const auto digits = [&] {
    const std::size_t end = std::min(rest.find_first_not_of("0123456789."), rest.size());
    const std::string_view number = rest.substr(0, end);
    rest.remove_prefix(end);
    return exact_decimal(number, "symmetry operation \"" + std::string(whole.substr(0, 60)) + "\"");
  };
  const std::size_t before = rest.size();
  const std::string_view start = rest;
  Rational value = digits();
  if (!rest.empty() && rest[0] == '/') {
    rest.remove_prefix(1);
    const Rational denominator = digits();
    if (denominator.is_zero()) fail_operation(whole, "denominator 0");
    return value / denominator;
  }
  if (start.substr(0, before - rest.size()).find('.') == std::string_view::npos) return value;
  // 0.3333 is a rounded fraction here, for a group has exact translations; tabulated ones are n/24.
  Rational nearest(round_half_up(Rational(24) * value), Integer(24));
  if (abs(nearest - value) > Rational(Integer(1), Integer(1000)))
    fail_operation(whole, "the translation is not a multiple of 1/24");
  return nearest;
}

void parse_row(std::string_view row, std::string_view whole, int i, Isometry& operation) {
  if (row.empty()) fail_operation(whole, "a coordinate is missing");
  constexpr std::size_t kLongestRow = 256;  // a sum of many fractions has a denominator without bound
  if (row.size() > kLongestRow)
    fail_operation(whole.substr(0, 60),
                   "a coordinate of more than " + std::to_string(kLongestRow) + " bytes");
  while (!row.empty()) {
    Rational factor(1);
    const bool has_sign = row[0] == '+' || row[0] == '-';
    if (row[0] == '-') factor = -1;
    if (has_sign) row.remove_prefix(1);
    if (row.empty()) fail_operation(whole, "a sign without a term");
    const bool number = (row[0] >= '0' && row[0] <= '9') || row[0] == '.';
    if (number) factor *= leading_number(row, whole);
    if (number && !row.empty() && row[0] == '*') row.remove_prefix(1);
    if (!row.empty() && row[0] >= 'x' && row[0] <= 'z') {
      operation.linear(i, row[0] - 'x') += factor;
      row.remove_prefix(1);
    } else if (number) {
      operation.translation[i] += factor;
    } else {
      fail_operation(whole, "write it like -x,y+1/2,-z");
    }
  }
}

Isometry modulo_cell(Isometry g) {
  for (int i = 0; i < 3; ++i) g.translation[i] -= Rational(floor(g.translation[i]));
  return g;
}

/// P_R = (I + R + ... ) / m times m, for a linear part of finite order at most 12.
Matrix fixed_part(const Matrix& linear) {
  Matrix sum = Matrix::identity(3), power = linear;
  for (int m = 1; m < 12 && !power.is_identity(); ++m, power = power * linear) sum = sum + power;
  return sum;
}

bool same_screw_or_glide(const Isometry& g, const Isometry& h) {
  if (g.linear != h.linear) return false;
  const Matrix projection = fixed_part(g.linear);
  Vector l(3);
  for (int code = 0; code < 125; ++code) {
    for (int i = 0, rest = code; i < 3; ++i, rest /= 5) l[i] = rest % 5 - 2;
    if ((projection * (g.translation - h.translation + l)).is_zero()) return true;
  }
  return false;
}

}  // namespace

Isometry parse_operation(std::string_view text) {
  std::string packed;
  for (const char c : text)
    if (std::isspace(static_cast<unsigned char>(c)) == 0 && c != '\'' && c != '"')
      packed += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  Isometry operation{Matrix(3), Vector(3)};
  std::string_view rest = packed;
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (i == 2)) fail_operation(text, "three coordinates are needed");
    parse_row(rest.substr(0, comma), text, i, operation);
    if (i < 2) rest.remove_prefix(comma + 1);
  }
  if (!operation.linear.is_integral() || abs(operation.linear.determinant()) != Rational(1))
    fail_operation(text, "the linear part does not map the lattice onto itself");
  return operation;
}

std::string operation_text(const Isometry& operation) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    std::string row;
    for (int j = 0; j < 3; ++j) {
      const Rational& r = operation.linear(i, j);
      if (r.is_zero()) continue;
      row += r.sign() == Sign::negative ? "-" : row.empty() ? "" : "+";
      if (abs(r) != Rational(1)) row += abs(r).to_string() + "*";
      row += static_cast<char>('x' + j);
    }
    const Rational& t = operation.translation[i];
    if (!t.is_zero()) row += (t.sign() == Sign::positive && !row.empty() ? "+" : "") + t.to_string();
    text += (i > 0 ? "," : "") + (row.empty() ? "0" : row);
  }
  return text;
}

std::vector<Isometry> group_of(const std::vector<Isometry>& operations) {
  const Isometry identity = Isometry::identity(3);
  std::set<Isometry> seen = {identity};
  std::vector<Isometry> group = {identity};
  for (std::size_t done = 0; done < group.size(); ++done) {
    for (const Isometry& g : operations) {
      const Isometry product = modulo_cell(g * group[done]);
      if (seen.insert(product).second) group.push_back(product);
      if (group.size() > kMaxOperations)
        throw InvalidInput("the symmetry operations do not generate a space group: more than " +
                           std::to_string(kMaxOperations) + " operations per cell");
    }
  }
  return {seen.begin(), seen.end()};
}

bool agree(const std::vector<Isometry>& group, const std::vector<Isometry>& other) {
  const auto covered = [](const std::vector<Isometry>& a, const std::vector<Isometry>& b) {
    return std::all_of(a.begin(), a.end(), [&](const Isometry& g) {
      return std::any_of(b.begin(), b.end(), [&](const Isometry& h) { return same_screw_or_glide(g, h); });
    });
  };
  return group.size() == other.size() && covered(group, other) && covered(other, group);
}

std::vector<Isometry> operations_of(Crystal& crystal) {
  const std::string shown = crystal.symbol.substr(0, 40);
  if (crystal.operations.empty()) {
    if (!crystal.settings.empty()) return group_of(crystal.settings.front().operations);
    throw InvalidInput(shown.empty() ? "the file gives neither symmetry operations nor a group symbol"
                                     : "the group symbol \"" + shown +
                                           "\" is unknown and the file lists no symmetry operations");
  }
  if (crystal.operations.size() > kMaxOperations)
    throw InvalidInput("more than " + std::to_string(kMaxOperations) + " symmetry operations are listed");
  std::vector<Isometry> listed;
  for (const std::string& text : crystal.operations) listed.push_back(parse_operation(text));
  std::vector<Isometry> group = group_of(listed);
  if (crystal.settings.empty()) {
    if (!shown.empty())
      crystal.notes.push_back("the symbol " + shown + " is unknown: the listed operations count");
    return group;
  }
  for (const GroupSetting& setting : crystal.settings)
    if (agree(group, group_of(setting.operations))) return group;
  // Some files list the operations of a centred group without its centring translations.
  for (const GroupSetting& setting : crystal.settings) {
    std::vector<Isometry> centred = listed;
    for (const Isometry& g : setting.operations)
      if (g.linear.is_identity()) centred.push_back(g);
    if (std::vector<Isometry> completed = group_of(centred); agree(completed, group_of(setting.operations))) {
      crystal.notes.push_back("the listed operations lack the centring translations of " + shown +
                              ": completed from the symbol");
      return completed;
    }
  }
  std::string text;
  for (const Isometry& g : group)
    if (text.size() < 200) text += "  " + operation_text(g);
  throw InvalidInput("the listed symmetry operations generate " + std::to_string(group.size()) +
                     " per cell (" + text.substr(2) + ") and contradict the symbol \"" + shown +
                     "\", which has " + std::to_string(group_of(crystal.settings.front().operations).size()) +
                     " or other screw and glide components");
}

}  // namespace flatdt::ref::cli
