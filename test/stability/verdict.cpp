// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.h"

#include <algorithm>
#include <cstdio>

namespace drill_rig_sim
{
const char* words(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::passes:
      return "passes";
    case Verdict::passes_by_halving:
      return "passes by halving";
    case Verdict::fails_diverged:
      return "fails: diverged";
    case Verdict::fails_not_converged:
      return "fails: not converged";
    case Verdict::fails_creep:
      return "fails: creep";
    case Verdict::fails_wrong:
      return "fails: wrong";
    case Verdict::refused:
      return "refused";
    case Verdict::too_slow:
      return "too slow";
    case Verdict::not_available:
      return "not available";
  }
  return "";
}

bool kept(const Row& row)
{
  const Verdict v = row.verdict;
  if (row.promise == Promise::none) return true;
  if (row.promise == Promise::passes) return passed(v);
  return passed(v) || v == Verdict::refused || v == Verdict::fails_not_converged ||
         (v == Verdict::too_slow && row.method == "ida");
}

const char* words(Promise promise)
{
  return promise == Promise::none ? "-" : promise == Promise::passes ? "passes" : "diagnostic";
}

void Rows::print_header()
{
  std::printf("group,case,value,method,element,promise,verdict,kept,figure,unit,text\n");
}

void Rows::add(const Row& row)
{
  std::string text = row.text;
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '\n', ' ');
  const bool held = kept(row);
  if (!held) ++broken_;
  std::printf("%s,%s,%s,%s,%s,%s,%s,%s,%.6g,%s,%s\n", row.group.c_str(), row.name.c_str(), row.value.c_str(), row.method.c_str(),
              row.element.c_str(), words(row.promise), words(row.verdict), held ? "yes" : "no", row.figure, row.unit.c_str(),
              text.c_str());
  std::fflush(stdout);
}

}  // namespace drill_rig_sim
