#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/case/table.hpp"
#include "core/case/time_function.hpp"
#include "core/case/units.hpp"

namespace parison::core {

struct NamedQuantities;

/// A value of a case file and its location in the file.
struct CaseNode {
  enum class Kind { text, number, flag, list, table };
  Kind kind = Kind::table;
  std::string file;
  int line = 0;      ///< 0 for a value that comes from the command line
  std::string key;   ///< with the keys that lead to it, "glass.mesh.size"
  std::string name;  ///< the last of them
  std::string text;
  std::string given;  ///< the text with the tolerance that was taken out of it; empty without one
  double number = 0;
  bool flag = false;
  std::vector<CaseNode> items;                   ///< of a list in its order, of a table by name
  std::shared_ptr<const NamedQuantities> known;  ///< what its text may name; null where the case has no dimensions
};

/// The member of a table; null where it has none, and of what is no table.
const CaseNode* member(const CaseNode& table, std::string_view name);
CaseNode* member(CaseNode& table, std::string_view name);

/// A case file as text with line numbers; nothing of it is interpreted.
struct CaseFile {
  std::string path, directory;
  CaseNode root;
  std::vector<std::string> overrides;  ///< assignments that were applied, as given
};

/// Parses the text of a case file; `file` is what sentences about it call it.
CaseNode parse_case_text(const std::string& text, const std::string& file);
/// Parses a case file, or the case.toml of a folder.
CaseFile read_case_file(const std::string& path);

/// Replaces a value of the file: `path=value`, the path keys joined by dots, the entry of a list by its number
/// from 0 or its name (an interface's by a tool it is for, which then gets one of its own), the value TOML or plain
/// text.
void override_value(CaseFile& file, const std::string& assignment);
/// A TOML value as in a case file, or a text without quotes; `place` is the node that it replaces.
CaseNode parse_value(const std::string& text, const CaseNode& place);

/// Throws a CaseError about a node: `file:line: key: message`.
[[noreturn]] void refuse(const CaseNode& at, const std::string& message);

/// A table read key by key. All keys it may have are named at once; any other is refused.
class CaseTable {
 public:
  CaseTable(const CaseNode& node, std::vector<std::string> keys);

  /// The value of one of the named keys, null when it is absent.
  const CaseNode* find(const std::string& key) const;
  /// The same; refused when it is absent.
  const CaseNode& get(const std::string& key) const;
  /// The entries of an array of tables, none when it is absent.
  std::vector<const CaseNode*> tables(const std::string& key) const;
  const CaseNode& node() const { return *node_; }

 private:
  const CaseNode* node_;
  std::vector<std::string> keys_;
};

/// A quantity in SI; plain numbers serve where the dimension is none.
double quantity(const CaseNode& node, const Dimension& dimension);
/// The quantity of a part of a node's text, a formula with the names of the case or "2.5 mm"; a plain number counts in
/// `unit` where there is one.
double text_quantity(const CaseNode& node, std::string_view text, const Dimension& dimension,
                     std::string_view unit = "");
/// Refuses a text with a tolerance behind more than a number.
void refuse_tolerance_of_formula(const CaseNode& node);
/// A quantity above zero.
double positive(const CaseNode& node, const Dimension& dimension);
/// A quantity not below zero.
double not_negative(const CaseNode& node, const Dimension& dimension);
/// A whole number above zero.
int count(const CaseNode& node);
bool flag(const CaseNode& node);
const std::string& text(const CaseNode& node);
/// A text of letters, digits, '_' and '-' only.
const std::string& identifier(const CaseNode& node);
/// A node that represents the key of another one.
CaseNode key_of(const CaseNode& node);
const std::vector<CaseNode>& list(const CaseNode& node);
const std::vector<CaseNode>& entries(const CaseNode& table);
/// Index of a text among the allowed ones.
int choice(const CaseNode& node, const std::vector<std::string>& allowed);
/// A constant, or pairs [["20 degC", "850 J/kg/K"], ...] with rising first members.
Table quantity_table(const CaseNode& node, const Dimension& x, const Dimension& y);
/// A constant, or pairs [["0 s", "50 degC"], ...] with rising times.
TimeFunction quantity_over_time(const CaseNode& node, const Dimension& dimension);
/// The same with no value below zero.
TimeFunction not_negative_over_time(const CaseNode& node, const Dimension& dimension);
/// The same with every value above zero.
TimeFunction positive_over_time(const CaseNode& node, const Dimension& dimension);

/// The candidate with the smallest edit distance from a word, empty when none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);
/// The same as part of a sentence: ` (did you mean "tools"?)`.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace parison::core
