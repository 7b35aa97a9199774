#include "results/tools/results_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/csv.hpp"
#include "base/whole_file.hpp"
#include "results/tools/checksum.hpp"

namespace trivium {

namespace fs = std::filesystem;

namespace {

Manifest read_manifest(const fs::path& file) {
  const std::string text = read_whole(file);
  try {
    const auto json = nlohmann::json::parse(text);
    return {json.at("results"), json.at("command"), json.at("commit"), json.at("csv_sha1")};
  } catch (const nlohmann::json::exception& error) {
    throw ResultsError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

std::size_t ResultsTable::column(const std::string& column_name) const {
  const auto at = std::find(columns.begin(), columns.end(), column_name);
  if (at == columns.end()) throw ResultsError(fmt::format("{}: no column \"{}\"", name, column_name));
  return static_cast<std::size_t>(at - columns.begin());
}

double ResultsTable::number(std::size_t row, const std::string& column_name) const {
  const double x = to_number(text(row, column_name));
  if (std::isnan(x))
    throw ResultsError(fmt::format("{}: row {}, column \"{}\": \"{}\" is not a number", name, row + 1,
                                   column_name, text(row, column_name)));
  return x;
}

double to_number(const std::string& text) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && !text.empty();
  return whole && std::isfinite(x) ? x : std::numeric_limits<double>::quiet_NaN();
}

ResultsTable read_results(const fs::path& csv) {
  const std::string text = read_whole(csv);
  ResultsTable table;
  table.name = csv.stem().string();
  table.csv_sha1 = sha1_of(text);
  try {
    table.rows = parse_csv(text);
    if (table.rows.empty()) throw ResultsError("the file is empty");
    table.columns = table.rows.front();
    table.rows.erase(table.rows.begin());
    for (std::size_t k = 0; k < table.rows.size(); ++k)
      if (table.rows[k].size() != table.columns.size())
        throw ResultsError(fmt::format("row {} has {} fields, the header {}", k + 1, table.rows[k].size(),
                                       table.columns.size()));
  } catch (const Error& error) {
    throw ResultsError(fmt::format("{}: {}", csv.string(), error.what()));
  }
  table.manifest = read_manifest(manifest_of(csv));
  return table;
}

fs::path manifest_of(fs::path csv) { return csv.replace_extension(".manifest.json"); }

}  // namespace trivium
