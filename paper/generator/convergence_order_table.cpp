/// One line for each method: the observed orders of r, v, lambda and the method's raw lambda, in every
/// formulation.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "paper/generator/figure.hpp"
#include "paper/generator/formulations.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

const std::vector<std::string> quantities{"r", "v", "lambda", "raw lambda"};

struct Line {
  std::string published;
  std::map<std::pair<std::string, std::string>, double> order;  ///< key: formulation and quantity
};

Tex order_cell(const Line& line, const std::string& formulation, const std::string& quantity) {
  const auto found = line.order.find({formulation, quantity});
  return found == line.order.end() ? Tex{"--"} : Tex{fmt::format("{:.2f}", found->second)};
}

}  // namespace

std::string convergence_order_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["convergence_order"];
  const std::vector<std::string> formulations = distinct(table, "formulation");
  std::vector<std::string> methods;
  std::map<std::string, Line> lines;
  Sample distance;
  std::size_t failed = 0, compared = 0;
  std::optional<double> observed;  // at the shortest step whose error is above rounding
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.text(row, "order") != "none") observed = table.number(row, "order");
    const std::string& verdict = table.text(row, "verdict");
    if (verdict == "none" || !observed) continue;  // only the row of the shortest step has a verdict
    const std::string &method = table.text(row, "method"), &formulation = table.text(row, "formulation"),
                      &quantity = table.text(row, "quantity"), &published = table.text(row, "published");
    if (!lines.contains(method)) methods.push_back(method);
    const double order = *std::exchange(observed, {});
    lines[method].order[{formulation, quantity}] = order;
    if (quantity == "r" && formulation == "r-omega") lines[method].published = published;
    ++compared;
    if (verdict != "ok") ++failed;
    distance.add(std::abs(order - std::stod(published)), method);
  }
  std::vector<TexColumn> columns{{"l", {"method"}}, {"r", {"published"}}};
  for (std::size_t k = 0; k < formulations.size(); ++k)
    for (const char* heading : {"$r$", "$v$", "$\\lambda$", "raw"}) columns.push_back({"r", {heading}});
  TexTable out(columns);
  out.head(headings_over(formulations, quantities.size()));
  for (const std::string& method : methods) {
    const Line& line = lines[method];
    std::vector<Tex> cells{text(method), text(line.published)};
    for (const std::string& formulation : formulations)
      for (const std::string& quantity : quantities) cells.push_back(order_cell(line, formulation, quantity));
    out.add(cells);
  }
  numbers.define("OrdersCompared", integer(compared));
  numbers.define("OrdersFailed", integer(failed));
  numbers.define("OrdersWorst", ratio_in_text(distance.worst()));
  numbers.define("OrdersWorstMethod", text(distance.worst_name()));
  return out.str("results/convergence_order.csv");
}

namespace {

/// A figure of error against step size in r-omega, for one method of every kind.
std::string slopes(const ResultsTable& table, const std::string& quantity, const Tex& label) {
  LogLogFigure figure({"$h$ [\\unit{\\second}]"}, label);
  for (const char* method :
       {"rkf78", "dopri5", "radau5", "hem4", "bdf4", "rattle4", "generalized-alpha", "hht"}) {
    LogLogFigure::Points points;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      if (table.text(row, "method") == method && table.text(row, "formulation") == "r-omega" &&
          table.text(row, "quantity") == quantity)
        points.emplace_back(table.text(row, "h"), table.text(row, "error"));
    figure.add(method == std::string("generalized-alpha") ? Tex{"gen.-$\\alpha$"} : text(method), points);
  }
  return figure.str("results/convergence_order.csv");
}

}  // namespace

std::string slopes_of_positions_figure(Results& results, Numbers&) {
  return slopes(results["convergence_order"], "r", {"error of positions [\\unit{\\metre}]"});
}

std::string slopes_of_lambda_figure(Results& results, Numbers&) {
  return slopes(results["convergence_order"], "lambda", {"error of $\\lambda$"});
}

}  // namespace trivium::paper
