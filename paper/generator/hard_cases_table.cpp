/// One line for each family of hard cases: how many rows survive, announce themselves, are not judged or
/// fail. The figure shows how lambda is lost near gimbal lock, with the laws u / theta^n.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "paper/generator/figure.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

constexpr std::array verdicts{"survives", "announces", "not judged", "FAILS"};

struct Family {
  std::size_t cases = 0;
  std::string last_case;
  std::array<std::size_t, verdicts.size()> count{};
};

/// `near_lock 0.01` has the difficulty 0.01; the easy twin is no point of the figure.
std::string difficulty_of(const std::string& name) {
  return name.starts_with("near_lock ") && !name.ends_with(")") ? name.substr(10) : "";
}

}  // namespace

std::string hard_cases_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["hard_cases"];
  std::vector<std::string> names;
  std::map<std::string, Family> families;
  std::array<std::size_t, verdicts.size()> all{};
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& name = table.text(row, "family");
    if (!families.contains(name)) names.push_back(name);
    Family& family = families[name];
    if (family.last_case != table.text(row, "case")) ++family.cases;
    family.last_case = table.text(row, "case");
    for (std::size_t v = 0; v < verdicts.size(); ++v)
      if (table.text(row, "verdict") == verdicts[v]) {
        ++family.count[v];
        ++all[v];
      }
  }
  TexTable out({{"l", {"family"}},
                {"r", {"cases"}},
                {"r", {"survive"}},
                {"r", {"announce"}},
                {"r", {"not judged"}},
                {"r", {"fail"}}});
  for (const std::string& name : names) {
    const Family& family = families[name];
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    out.add({text(words), integer(family.cases), integer(family.count[0]), integer(family.count[1]),
             integer(family.count[2]), integer(family.count[3])});
  }
  numbers.define("HardSurvive", integer(all[0]));
  numbers.define("HardAnnounce", integer(all[1]));
  numbers.define("HardUnjudged", integer(all[2]));
  numbers.define("HardFail", integer(all[3]));
  return out.str("results/hard_cases.csv");
}

std::string gimbal_lock_figure(Results& results, Numbers&) {
  const ResultsTable& table = results["hard_cases"];
  LogLogFigure figure({"$\\theta$ [\\unit{\\radian}]"}, {"error of $\\lambda$"});
  for (const char* formulation : {"r-epsilon", "r-epsilon-omega-first", "r-omega", "r-p"}) {
    LogLogFigure::Points points;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      if (const std::string theta = difficulty_of(table.text(row, "case"));
          !theta.empty() && table.text(row, "formulation") == formulation &&
          table.text(row, "method") == "printed")
        if (table.number(row, "value") <= 1) points.emplace_back(theta, table.text(row, "value"));
    figure.add(text(formulation), points);
  }
  const double u = std::ldexp(1, -53);
  for (const auto& [n, name] : {std::pair{3, "$u/\\theta^3$"}, {1, "$u/\\theta$"}, {0, "$u$"}}) {
    LogLogFigure::Points law;
    for (const char* theta : {"0.1", "1e-8"}) {
      const double from = std::stod(theta);
      const double at = n > 0 ? std::max(from, std::pow(u, 1.0 / n)) : from;  // up to an error of 1
      law.emplace_back(fmt::format("{:g}", at), fmt::format("{:g}", u / std::pow(at, n)));
    }
    figure.add({name}, law);
  }
  return figure.str("results/hard_cases.csv");
}

}  // namespace trivium::paper
