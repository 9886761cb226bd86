/// Edits of a valid triangulation and its instance, and what each must do to the verdict.
///
/// An edit takes the data of ref and gives the texts of two files, so that whatever judges it reads them with
/// a parser of its own. Whether an edit applies, and whether its result is valid, is decided here by exact
/// reasoning about the valid triangulation that was edited, never by the checker that is tested.
/// Invariants: an edit is a function of (kind, base, seed).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base.hpp"
#include "flatdt/checker/verdict.hpp"
#include "random.hpp"

namespace flatdt::edits {

using Conditions = std::vector<checker::ConditionName>;

/// What must be said of an edited pair of files. Conditions that are not named may have any status.
struct Expectation {
  enum class Effect {
    keeps,       ///< valid as before: verified
    breaks,      ///< refuted (malformed if a condition of group.* is the one that fails)
    unreadable,  ///< a file breaks the grammar: its parser must refuse it
  };
  Effect effect = Effect::keeps;
  Conditions fail;    ///< all of these must fail
  Conditions one_of;  ///< if not empty: at least one of these must fail
  Conditions hold;    ///< these must still hold
};

[[nodiscard]] Expectation keeps();
[[nodiscard]] Expectation breaks(Conditions fail, Conditions one_of = {}, Conditions hold = {});
[[nodiscard]] Expectation unreadable();

/// The two files after an edit.
struct Files {
  std::string instance;
  std::string triangulation;
};

/// A kind of edit. `apply` gives nothing where the kind does not apply to the base, or where the result of
/// the choices made is not what the expectation speaks of.
struct Kind {
  std::string_view name;
  std::string_view reason;  ///< why the expectation is right
  Expectation expectation;
  std::function<std::optional<Files>(const Base&, Random&)> apply;
};

/// All kinds, in the order of the table.
[[nodiscard]] const std::vector<Kind>& kinds();

/// The edited files, or nothing where the kind does not apply.
[[nodiscard]] std::optional<Files> edit(const Kind& kind, const Base& base, std::uint64_t seed);

/// Why the verdict on an edited pair is not what the kind expects; empty if it is. `verdict` is nothing if a
/// parser refused a file.
[[nodiscard]] std::string contradiction(const Expectation& expectation,
                                        const std::optional<checker::Verdict>& verdict);

/// The groups of kinds, one source file each.
std::vector<Kind> cell_kinds();
std::vector<Kind> shape_kinds();
std::vector<Kind> label_kinds();
std::vector<Kind> flip_kinds();
std::vector<Kind> cover_kinds();
std::vector<Kind> point_kinds();
std::vector<Kind> group_kinds();
std::vector<Kind> rewriting_kinds();
std::vector<Kind> coordinate_kinds();

}  // namespace flatdt::edits
