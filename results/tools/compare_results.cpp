/// Compares a regenerated results file with the accepted one by the rules of results/schema.json. Fails if
/// they differ.

#include <fmt/format.h>

#include <cstdio>

#include "base/exit_code.hpp"
#include "base/json_writer.hpp"
#include "base/program_options.hpp"
#include "base/table.hpp"
#include "results/tools/results_comparison.hpp"

namespace trivium {

namespace {

std::string text(const std::vector<Difference>& differences) {
  Table table({"row", "column", "accepted", "regenerated", "rule"});
  for (const Difference& d : differences) table.add({d.row, d.column, d.accepted, d.regenerated, d.rule});
  return table.text();
}

std::string json(const std::string& name, const std::vector<Difference>& differences) {
  JsonWriter json;
  json.begin_object().text("results", name).flag("passed", differences.empty()).begin_array("differences");
  for (const Difference& d : differences)
    json.begin_object()
        .text("row", d.row)
        .text("column", d.column)
        .text("accepted", d.accepted)
        .text("regenerated", d.regenerated)
        .text("rule", d.rule)
        .end_object();
  return json.end_array().end_object().str();
}

int run(const std::string& accepted_csv, const std::string& regenerated_csv, const std::string& schema_file,
        bool as_json) {
  const ResultsTable accepted = read_results(accepted_csv), regenerated = read_results(regenerated_csv);
  const auto all = read_schema(schema_file);
  const auto differences = compare_results(find_schema(all, accepted.name), accepted, regenerated);
  if (as_json)
    fmt::print("{}", json(accepted.name, differences));
  else if (differences.empty())
    fmt::print("{}: {} rows agree with the accepted file (commit {})\n", accepted.name, accepted.rows.size(),
               accepted.manifest.commit);
  else
    fmt::print("{}", text(differences));
  return differences.empty() ? exit_done : exit_criterion_failed;
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  ProgramOptions options("Compares a regenerated results file with the accepted one", "compare_results");
  std::string accepted, regenerated, schema;
  bool as_json = false;
  options.add_option("ACCEPTED", &accepted, "Accepted CSV file, with the manifest next to it").required();
  options.add_option("REGENERATED", &regenerated, "Regenerated CSV file, with the manifest next to it")
      .required();
  options.add_option("--schema", &schema, "Schema of the results (results/schema.json)").required();
  options.add_flag("--json", &as_json, "JSON on stdout");
  return options.run(argc, argv, [&] { return run(accepted, regenerated, schema, as_json); });
}
