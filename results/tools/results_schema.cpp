#include "results/tools/results_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <utility>

#include "base/whole_file.hpp"
#include "results/tools/results_table.hpp"

namespace trivium {

namespace {

using nlohmann::json;

Quantity read_quantity(const json& value) {
  if (value.is_number()) return {value.get<double>(), ""};
  return {value.value("times", 1.0), value.at("column").get<std::string>()};
}

Rule read_rule(const json& rule) {
  if (rule == "exact") return Exact{};
  if (rule == "shown") return Shown{};
  if (rule.contains("relative")) return Relative{rule.at("relative").get<double>()};
  const json& rounding = rule.at("rounding");
  return Rounding{read_quantity(rounding.at("bound")), read_quantity(rounding.at("floor")),
                  rounding.at("factor").get<double>()};
}

bool has_column(const ResultsSchema& schema, const std::string& name) {
  return std::any_of(schema.columns.begin(), schema.columns.end(),
                     [&](const ColumnSchema& c) { return c.name == name; });
}

void expect_column(const ResultsSchema& schema, const std::string& name) {
  if (!name.empty() && !has_column(schema, name))
    throw ResultsError(fmt::format("{}: no column \"{}\"", schema.name, name));
}

ResultsSchema read_one(const std::string& name, const json& value) {
  ResultsSchema schema{name, value.at("question"), value.at("command"), value.at("key"), {}};
  for (const json& column : value.at("columns"))
    schema.columns.push_back(
        {column.at("name"), column.at("meaning"), column.at("unit"), read_rule(column.at("compare"))});
  for (const std::string& key : schema.key) expect_column(schema, key);
  for (const ColumnSchema& column : schema.columns)
    if (const auto* rounding = std::get_if<Rounding>(&column.rule)) {
      expect_column(schema, rounding->bound.column);
      expect_column(schema, rounding->floor.column);
    }
  return schema;
}

}  // namespace

std::vector<ResultsSchema> read_schema(const std::filesystem::path& file) {
  const std::string text = read_whole(file);
  std::vector<ResultsSchema> all;
  try {
    const json root = json::parse(text);
    for (const auto& [name, value] : root.at("files").items()) all.push_back(read_one(name, value));
  } catch (const json::exception& error) {
    throw ResultsError(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const ResultsError& error) {
    throw ResultsError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return all;
}

ResultsSchema expanded(ResultsSchema schema, const std::vector<std::string>& columns) {
  std::vector<ColumnSchema> all;
  for (const ColumnSchema& column : schema.columns) {
    const std::size_t first = all.size();
    if (column.name.find('*') != std::string::npos) {
      const std::regex name(std::regex_replace(column.name, std::regex("\\*"), "[^/]+"));
      for (std::size_t k = first; k < columns.size() && std::regex_match(columns[k], name); ++k) {
        all.push_back(column);
        all.back().name = columns[k];
      }
    }
    if (all.size() == first) all.push_back(column);  // keep the name with `*`: it is reported as missing
  }
  schema.columns = std::move(all);
  return schema;
}

const ResultsSchema& find_schema(const std::vector<ResultsSchema>& all, const std::string& name) {
  for (const ResultsSchema& schema : all)
    if (schema.name == name) return schema;
  throw ResultsError(fmt::format("the schema has no results file \"{}\"", name));
}

}  // namespace trivium
