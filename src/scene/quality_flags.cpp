// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/quality_flags.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "survey_rows.h"
#include "survey_split.h"
#include "survey_words.h"

namespace drill_rig_sim
{
namespace
{
using Set = std::set<std::string>;

bool is_in(const Set& set, const std::string& word)
{
  return set.count(word) > 0;
}

// --- names

// the sense of a word of a column's name, none: it has none
FlagSense sense_of(const std::string& word)
{
  static const Set status = {"status", "flag", "flags", "comment", "comments", "remark", "remarks", "note", "notes"},
                   quality = {"quality", "qc", "qa", "qaqc", "qf", "qflag", "qcflag", "dqf", "qualityflag", "dataquality"},
                   good = {"valid", "validity", "isvalid", "accepted", "acc", "acceptance",
                           "ok",    "good",     "pass",    "passed",   "use", "usable"},
                   bad = {"bad",      "isbad",   "invalid",      "rejected", "reject",
                          "excluded", "suspect", "questionable", "ignore",   "outlier"};
  return is_in(bad, word)       ? FlagSense::bad_if_true
         : is_in(good, word)    ? FlagSense::good_if_true
         : is_in(quality, word) ? FlagSense::quality
         : is_in(status, word)  ? FlagSense::status
                                : FlagSense::none;
}

// words that a column of flags may have beside, which name no signal
bool is_filler(const std::string& word)
{
  static const Set fillers = {"survey", "svy",         "station", "data",  "row",  "record", "sample",
                              "sensor", "measurement", "reading", "value", "code", "check",  "result",
                              "point",  "is",          "y",       "n",     "do",   "opc"};
  return is_in(fillers, word);
}

// "HookLoadQC", of which signs part no words
FlagName name_in_one_word(const std::string& word)
{
  for (const char* flag : {"qualityflag", "qcflag", "quality", "status", "flag", "qc"})
  {
    const std::string end = flag;
    if (word.size() > end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0)
      return {sense_of(end), word.substr(0, word.size() - end.size())};
  }
  return {};
}

// --- cells

bool is_blank(const std::string& cell)
{
  double value = 0.0;
  return cell.find_first_of("0123456789") == std::string::npos && read_cell(cell, false, value) == CellKind::missing;
}

// a null value too
std::optional<double> number_in(const std::string& cell)
{
  double value = 0.0;
  const CellKind kind = read_cell(cell, false, value);
  return kind == CellKind::wrong || is_blank(cell) ? std::nullopt : std::optional<double>(value);
}

bool stands_for_null(double number)
{
  static const std::set<double> sizes = {999.0, 999.25, 9999.0, 9999.25, 99999.0, 99999.25, 999999.0};
  return sizes.count(number < 0.0 ? -number : number) > 0;
}

bool is_bad_word(const std::string& word)
{
  static const Set words = {
      "bad",        "questionable", "suspect",  "suspicious",   "suspected",    "doubtful", "dubious", "invalid",   "reject",
      "rejected",   "fail",         "failed",   "failure",      "fails",        "poor",     "error",   "err",       "erroneous",
      "wrong",      "unreliable",   "unusable", "unacceptable", "faulty",       "fault",    "corrupt", "corrupted", "spike",
      "outlier",    "stale",        "frozen",   "offline",      "disconnected", "missing",  "null",    "nan",       "uncertain",
      "superseded", "void",         "discard",  "discarded",    "deleted",      "ignore",   "ignored", "excluded",  "noisy",
      "unaccepted", "disqualified", "replaced", "unqualified"};
  return is_in(words, word);
}

bool is_good_word(const std::string& word)
{
  static const Set words = {"good",       "ok",         "okay",   "valid", "pass",      "passed",    "accept",
                            "accepted",   "acceptable", "normal", "fine",  "approved",  "verified",  "reliable",
                            "definitive", "usable",     "use",    "clean", "confirmed", "validated", "healthy"};
  return is_in(words, word);
}

bool is_derived_word(const std::string& word)
{
  static const Set words = {"interpolated", "extrapolated", "projected", "projection", "estimated", "tie", "tiein", "tieon"};
  return is_in(words, word);
}

bool is_negation(const std::string& word)
{
  return word == "not" || word == "no" || word == "non" || word == "un" || word == "out";
}

// Of a text in words: "BAD", "not valid", "QC fail: dip". A single word that turns the next around is bad of good and good of
// bad.
FlagMeaning meaning_of_words(const std::string& cell)
{
  bool good = false, derived = false, turned = false;
  for (const std::string& word : name_words(cell))
  {
    const bool limits = word == "range" || word == "spec" || word == "specification" || word == "limits" || word == "tolerance";
    const bool is_bad = turned ? is_good_word(word) || limits : is_bad_word(word);
    if (is_bad && !(turned && is_bad_word(word))) return FlagMeaning::bad;
    good = good || (turned ? is_bad_word(word) : is_good_word(word) || limits);
    derived = derived || is_derived_word(word);
    turned = is_negation(word) || (turned && word == "of");
  }
  return good ? FlagMeaning::good : derived ? FlagMeaning::derived : FlagMeaning::other;
}

// Whether a text of a column that may hold other things speaks of quality: "bad data", "rejected: dip", not "bad weather".
bool is_of_quality(const std::string& cell)
{
  static const Set of_rigs = {"bad", "missing", "fault", "faulty", "error", "poor", "wrong", "failure", "void", "noisy"};
  const Words words = name_words(cell);
  if (words.empty()) return false;
  if (is_bad_word(words.front()) && !is_in(of_rigs, words.front())) return true;
  return std::all_of(words.begin(), words.end(),
                     [](const std::string& word)
                     {
                       return is_bad_word(word) || is_good_word(word) || is_derived_word(word) || is_negation(word) ||
                              is_filler(word) || sense_of(word) != FlagSense::none || word == "of" || word == "range";
                     });
}

// letters that come in sets, the first ones good: pass and fail, accepted and rejected
std::optional<FlagMeaning> meaning_of_letter(const std::string& letter, const std::vector<std::string>& all)
{
  struct Letters
  {
    Set good, bad;
  };
  static const std::array<Letters, 4> sets = {
      {{{"p"}, {"f"}}, {{"g"}, {"b", "q", "s", "u", "m"}}, {{"a"}, {"r"}}, {{"v"}, {"i", "s"}}}};
  for (const Letters& set : sets)
  {
    if (!std::all_of(all.begin(), all.end(), [&](const std::string& one) { return is_in(set.good, one) || is_in(set.bad, one); }))
      continue;
    return is_in(set.good, letter) ? FlagMeaning::good : FlagMeaning::bad;
  }
  return std::nullopt;
}

// true, 1, yes: of a column whose name has their sense
std::optional<FlagMeaning> meaning_of_truth(FlagSense sense, const std::string& cell)
{
  if (sense != FlagSense::good_if_true && sense != FlagSense::bad_if_true) return std::nullopt;
  static const Set yes = {"true", "t", "yes", "y", "1", "1.0", "x"}, no = {"false", "f", "no", "n", "0", "0.0"};
  if (!is_in(yes, cell) && !is_in(no, cell)) return std::nullopt;
  return is_in(yes, cell) == (sense == FlagSense::good_if_true) ? FlagMeaning::good : FlagMeaning::bad;
}

// Quality codes of OPC (OPC Foundation, Data Access 3.00, section 6.8): 192 to 219 good, 64 to 88 uncertain, below bad; with a
// good one among them no other meaning of the numbers is likely.
bool are_of_opc(const std::vector<double>& numbers)
{
  static const std::set<double> codes = {0, 4, 8, 12, 16, 20, 24, 28, 32, 64, 68, 80, 84, 88, 192, 216};
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return codes.count(number) > 0; }) &&
         std::any_of(numbers.begin(), numbers.end(), [](double number) { return number >= 192.0; });
}

// The cells of one column, all of them together.
class FlagColumn
{
public:
  FlagColumn(FlagSense sense, const std::vector<std::string>& cells) : sense_(sense)
  {
    for (const std::string& cell : cells)
    {
      const std::string text = lowered(trimmed(cell));
      if (is_blank(text)) continue;
      texts_.push_back(text);
      const auto number = number_in(text);
      if (number && !stands_for_null(*number)) codes_.push_back(*number);
      has_nulls_ = has_nulls_ || (number && stands_for_null(*number));
      names_good_ = names_good_ || (is_of_quality(text) && meaning_of_words(text) == FlagMeaning::good);
    }
    has_blanks_ = texts_.size() < cells.size();
  }

  bool differ() const { return texts_.size() + (has_blanks_ ? 1U : 0U) > 1; }

  FlagMeaning meaning_of(const std::string& text) const
  {
    if (is_blank(text)) return FlagMeaning::other;
    if (const auto truth = meaning_of_truth(sense_, text)) return *truth;
    if (const auto number = number_in(text)) return meaning_of_number(*number);
    if (text.size() == 1) return meaning_of_letter(text, texts_).value_or(FlagMeaning::other);
    const bool speaks_of_quality = sense_ != FlagSense::status || names_good_ || is_of_quality(text);
    return speaks_of_quality ? meaning_of_words(text) : FlagMeaning::other;
  }

private:
  // beside null values one other number is good
  FlagMeaning meaning_of_number(double number) const
  {
    const bool is_null = stands_for_null(number);
    if (!is_null && are_of_opc(codes_)) return number >= 192.0 ? FlagMeaning::good : FlagMeaning::bad;
    if (sense_ == FlagSense::status && codes_.size() > 1) return FlagMeaning::other;  // of what the rig does
    if (is_null) return FlagMeaning::bad;
    return has_nulls_ && codes_.size() == 1 ? FlagMeaning::good : FlagMeaning::other;
  }

  FlagSense sense_;
  std::vector<std::string> texts_;  // that are not blank
  std::vector<double> codes_;       // numbers that stand for no null
  bool has_nulls_ = false, has_blanks_ = false, names_good_ = false;
};
}  // namespace

FlagName flag_name(const std::string& name)
{
  FlagName found;
  for (const std::string& word : name_words(name))
  {
    const FlagSense sense = sense_of(word);
    if (sense == FlagSense::none && !is_filler(word)) found.of += word;
    if (sense > found.sense) found.sense = sense;
  }
  return found.sense == FlagSense::none ? name_in_one_word(found.of) : found;
}

FlagCells flag_cells(FlagSense sense, const std::vector<std::string>& cells)
{
  FlagCells found;
  if (sense == FlagSense::none) return found;
  const FlagColumn column(sense, cells);
  for (const std::string& cell : cells) found.meanings.push_back(column.meaning_of(lowered(trimmed(cell))));
  const auto any = [&](FlagMeaning meaning)
  { return std::find(found.meanings.begin(), found.meanings.end(), meaning) != found.meanings.end(); };
  const bool any_good = any(FlagMeaning::good), any_bad = any(FlagMeaning::bad);
  found.known = any_good || any_bad;
  found.unclear = !found.known && column.differ();
  // where only the bad ones are marked, the others are good
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (any_bad && !any_good && is_blank(lowered(trimmed(cells[i])))) found.meanings[i] = FlagMeaning::good;
  return found;
}

}  // namespace drill_rig_sim
