#include "results/tools/results_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

namespace trivium {

namespace {

/// The text of a number that does not exist, such as the difference of multipliers when no multiplier is
/// unique.
constexpr const char* no_number = "none";

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>  // clang++ 14 does not deduce it
Overloaded(Functions...)->Overloaded<Functions...>;

double value_of(const Quantity& quantity, const ResultsTable& table, std::size_t row) {
  return quantity.times * (quantity.column.empty() ? 1.0 : table.number(row, quantity.column));
}

std::string text_of(const Rule& rule) {
  return std::visit(
      Overloaded{[](const Exact&) -> std::string { return "the same text"; },
                 [](const Shown&) -> std::string { return "not compared"; },
                 [](const Relative& r) { return fmt::format("within {:g}, relative", r.tolerance); },
                 [](const Rounding& r) { return fmt::format("rounding, factor {:g}", r.factor); }},
      rule);
}

/// One cell of a results file.
struct Cell {
  const ResultsTable& table;
  std::size_t row;
  const std::string& text;

  Cell(const ResultsTable& table_, std::size_t row_, const std::string& column)
      : table(table_), row(row_), text(table_.text(row_, column)) {}
  double number() const { return to_number(text); }
};

/// Why a value violates its rule on its own; empty if it does not. The comparisons are written so that NaN
/// fails.
std::string defect(const Rule& rule, const Cell& cell) {
  const bool is_number = !std::isnan(cell.number());
  if (std::holds_alternative<Relative>(rule))
    return is_number || cell.text == no_number ? "" : "a finite number or none";
  const auto* rounding = std::get_if<Rounding>(&rule);
  if (rounding == nullptr || cell.text == no_number) return "";
  const double bound = value_of(rounding->bound, cell.table, cell.row);
  return cell.number() >= 0 && cell.number() <= bound ? "" : fmt::format("within [0, {:.3g}]", bound);
}

bool equal(const Rule& rule, const Cell& a, const Cell& b) {
  if (std::holds_alternative<Shown>(rule)) return true;
  const double x = a.number(), y = b.number();
  if (std::holds_alternative<Exact>(rule) || std::isnan(x) || std::isnan(y)) return a.text == b.text;
  if (const auto* relative = std::get_if<Relative>(&rule))
    return std::abs(x - y) <= relative->tolerance * std::max(std::abs(x), std::abs(y));
  const auto& rounding = std::get<Rounding>(rule);
  const double floored_x = std::max(x, value_of(rounding.floor, a.table, a.row));
  const double floored_y = std::max(y, value_of(rounding.floor, b.table, b.row));
  return std::max(floored_x, floored_y) <= rounding.factor * std::min(floored_x, floored_y);
}

std::string key_of(const ResultsSchema& schema, const ResultsTable& table, std::size_t row) {
  std::vector<std::string> parts;
  for (const std::string& column : schema.key) parts.push_back(table.text(row, column));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::string> column_names(const ResultsSchema& schema) {
  std::vector<std::string> names;
  for (const ColumnSchema& column : schema.columns) names.push_back(column.name);
  return names;
}

std::map<std::string, std::size_t> rows_by_key(const ResultsSchema& schema, const ResultsTable& table) {
  std::map<std::string, std::size_t> rows;
  for (std::size_t k = 0; k < table.rows.size(); ++k) rows.emplace(key_of(schema, table, k), k);
  return rows;
}

/// The command without --plot: drawing a figure does not change the table.
std::string without_figures(const std::string& command) {
  static const std::regex figures(" --plot \\S+");
  return std::regex_replace(command, figures, "");
}

}  // namespace

std::vector<Difference> check_results(const ResultsSchema& any, const ResultsTable& table, bool regenerated) {
  const ResultsSchema schema = expanded(any, table.columns);
  std::vector<Difference> found;
  const auto report = [&](std::string row, std::string column, std::string is, std::string rule) {
    Difference d{std::move(row), std::move(column), "", "", std::move(rule)};
    (regenerated ? d.regenerated : d.accepted) = std::move(is);
    found.push_back(std::move(d));
  };
  const std::string command = fmt::format("{} --csv {}.csv", fmt::join(schema.command, " "), schema.name);
  if (table.manifest.results != schema.command.front())
    report("", "manifest: results", table.manifest.results, schema.command.front());
  if (without_figures(table.manifest.command) != command)
    report("", "manifest: command", table.manifest.command, command);
  if (!table.intact())
    report("", "manifest: csv_sha1", table.csv_sha1, "as in the manifest: " + table.manifest.csv_sha1);
  if (table.columns != column_names(schema)) {
    report("", "columns", fmt::format("{}", fmt::join(table.columns, ",")),
           fmt::format("{}", fmt::join(column_names(schema), ",")));
    return found;
  }
  const auto by_key = rows_by_key(schema, table);
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const std::string key = key_of(schema, table, k);
    if (by_key.at(key) != k) report(key, "", "repeated", "one row per key");
    for (const ColumnSchema& column : schema.columns) {
      const Cell cell(table, k, column.name);
      if (std::string why = defect(column.rule, cell); !why.empty())
        report(key, column.name, cell.text, std::move(why));
    }
  }
  return found;
}

std::vector<Difference> compare_rows(const ResultsSchema& any, const ResultsTable& accepted,
                                     const ResultsTable& regenerated) {
  const ResultsSchema schema = expanded(any, accepted.columns);
  std::vector<Difference> found;
  const auto old_rows = rows_by_key(schema, accepted), new_rows = rows_by_key(schema, regenerated);
  for (const auto& [key, row] : old_rows) {
    const auto other = new_rows.find(key);
    if (other == new_rows.end()) {
      found.push_back({key, "", "present", "missing", "the same rows"});
      continue;
    }
    for (const ColumnSchema& column : schema.columns) {
      const Cell a(accepted, row, column.name), b(regenerated, other->second, column.name);
      if (!equal(column.rule, a, b))
        found.push_back({key, column.name, a.text, b.text, text_of(column.rule)});
    }
  }
  for (const auto& [key, row] : new_rows)
    if (!old_rows.contains(key)) found.push_back({key, "", "missing", "present", "the same rows"});
  return found;
}

std::vector<Difference> compare_results(const ResultsSchema& schema, const ResultsTable& accepted,
                                        const ResultsTable& regenerated) {
  std::vector<Difference> found = check_results(schema, accepted);
  for (Difference& d : check_results(schema, regenerated, true)) found.push_back(std::move(d));
  if (accepted.columns != regenerated.columns)
    found.push_back({"", "columns", fmt::format("{}", fmt::join(accepted.columns, ",")),
                     fmt::format("{}", fmt::join(regenerated.columns, ",")), "the same columns"});
  if (accepted.columns != column_names(expanded(schema, accepted.columns)) ||
      regenerated.columns != accepted.columns)
    return found;
  for (Difference& d : compare_rows(schema, accepted, regenerated)) found.push_back(std::move(d));
  return found;
}

}  // namespace trivium
