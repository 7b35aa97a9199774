/// Accepted results are protected: every compared column by its rule, and every digit by the checksum of the
/// file.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "base/whole_file.hpp"
#include "results/tools/checksum.hpp"
#include "results/tools/results_acceptance.hpp"
#include "results/tools/results_comparison.hpp"
#include "results/tools/results_writer.hpp"

namespace trivium {
namespace {

namespace fs = std::filesystem;

const fs::path accepted_directory = TRIVIUM_RESULTS_DIR;

struct Accepted {
  ResultsSchema schema;
  ResultsTable table;
};

Accepted accepted(const std::string& name) {
  const ResultsTable table = read_results(accepted_directory / (name + ".csv"));
  return {expanded(find_schema(read_schema(accepted_directory / "schema.json"), name), table.columns), table};
}

std::vector<Accepted> all_accepted() {
  std::vector<Accepted> all;
  for (const ResultsSchema& schema : read_schema(accepted_directory / "schema.json"))
    all.push_back(accepted(schema.name));
  return all;
}

/// A value that the rule must refuse when compared with `cell`.
std::string tampered(const Rule& rule, const std::string& cell) {
  const double x = to_number(cell);
  if (const auto* relative = std::get_if<Relative>(&rule))
    return fmt::format("{:.6e}", (1.001 + 2 * relative->tolerance) * x);
  if (std::holds_alternative<Rounding>(rule) && !std::isnan(x)) {
    const std::size_t e = cell.find('e');  // the exponent grows by 4: 3.1e-16 becomes 3.1e-12
    return cell.substr(0, e) + fmt::format("e{}", std::stoi(cell.substr(e + 1)) + 4);
  }
  return std::isnan(x) ? (cell == "none" ? "1e-16" : cell + "x") : fmt::format("{}", x + 1);
}

/// The table with one row only.
ResultsTable only_row(const ResultsTable& table, std::size_t row) {
  ResultsTable out = table;
  out.rows = {table.rows[row]};
  return out;
}

/// Whether a value is so small that 10^4 times the value still counts as equal to the floor. The rule does
/// not protect such a value; only the checksum does.
bool is_under_the_floor(const Rule& rule, const ResultsTable& row, const std::string& cell) {
  const auto* rounding = std::get_if<Rounding>(&rule);
  if (rounding == nullptr) return false;
  const Quantity& floor = rounding->floor;
  const double least = floor.times * (floor.column.empty() ? 1.0 : row.number(0, floor.column));
  return 1e4 * to_number(cell) <= rounding->factor * least;
}

/// The first row in which the column holds a number.
std::size_t first_number(const ResultsTable& table, const std::string& column) {
  std::size_t row = 0;
  while (std::isnan(to_number(table.text(row, column)))) ++row;
  return row;
}

TEST(AcceptedResults, AreWhatTheirSchemaSays) {
  ASSERT_FALSE(all_accepted().empty());
  for (const auto& [schema, table] : all_accepted())
    for (const Difference& d : check_results(schema, table))
      ADD_FAILURE() << schema.name << ": " << d.row << ", " << d.column << ": " << d.accepted << "; "
                    << d.rule;
}

TEST(AcceptedResults, HaveASchemaEach) {
  const auto all = read_schema(accepted_directory / "schema.json");
  for (const fs::directory_entry& entry : fs::directory_iterator(accepted_directory))
    if (entry.path().extension() == ".csv") {
      EXPECT_NO_THROW(find_schema(all, entry.path().stem().string()));
    }
}

TEST(Rules, EveryCellIsGuarded) {
  for (const auto& [schema, table] : all_accepted())
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      for (const ColumnSchema& column : schema.columns) {
        if (std::holds_alternative<Shown>(column.rule)) continue;
        const ResultsTable before = only_row(table, row);
        ASSERT_TRUE(compare_rows(schema, before, before).empty());
        ResultsTable after = before;
        std::string& cell = after.rows[0][table.column(column.name)];
        if (is_under_the_floor(column.rule, before, cell)) continue;
        cell = tampered(column.rule, cell);
        EXPECT_FALSE(compare_rows(schema, before, after).empty())
            << schema.name << ", row " << row + 1 << ", " << column.name << ": " << cell;
      }
}

TEST(Rules, AColumnForEveryPairOfFormulationsIsExpectedAsAccepted) {
  const auto all = read_schema(accepted_directory / "schema.json");
  const ResultsSchema& schema = find_schema(all, "lambda_invariance");
  const ResultsTable table = accepted("lambda_invariance").table;
  ResultsTable fewer = table, none = table;
  const auto drop = [](ResultsTable& from, const std::string& name) {
    const auto at = static_cast<std::ptrdiff_t>(from.column(name));
    from.columns.erase(from.columns.begin() + at);
    for (auto& row : from.rows) row.erase(row.begin() + at);
  };
  drop(fewer, "r-omega/r-p");
  EXPECT_TRUE(check_results(schema, fewer).empty());
  EXPECT_FALSE(compare_results(schema, table, fewer).empty());
  for (const std::string& name : table.columns)
    if (name.find('/') != std::string::npos) drop(none, name);
  EXPECT_FALSE(check_results(schema, none).empty());
}

TEST(Rules, AnotherCompilersRoundingPasses) {
  const auto [schema, table] = accepted("lambda_invariance");
  ResultsTable a = only_row(table, first_number(table, "r-omega/r-p")), b = a;
  a.rows[0][table.column("r-omega/r-p")] = "0";
  b.rows[0][table.column("r-omega/r-p")] = "2.2e-15";
  EXPECT_TRUE(compare_rows(schema, a, b).empty());
}

TEST(Rules, WhatIsNoNumberOrOverTheBoundFails) {
  const auto [schema, table] = accepted("lambda_invariance");
  for (const char* wrong : {"nan", "inf", "-1e-16", "", "1e-16 ", "1"}) {
    ResultsTable changed = only_row(table, first_number(table, "r-omega/r-p"));
    changed.rows[0][table.column("r-omega/r-p")] = wrong;
    EXPECT_FALSE(check_results(schema, changed).empty()) << wrong;
  }
}

TEST(Rules, RowsThatAreMissingAddedOrRepeatedFail) {
  for (const auto& [schema, table] : all_accepted()) {
    ResultsTable fewer = table, repeated = table;
    fewer.rows.pop_back();
    repeated.rows.push_back(table.rows.front());
    EXPECT_EQ(compare_rows(schema, table, fewer).size(), 1U);
    EXPECT_EQ(compare_rows(schema, fewer, table).size(), 1U);
    EXPECT_EQ(check_results(schema, repeated).size(), 1U);
  }
}

/// Results with two rows, written to a temporary folder and read back.
class WrittenResults : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(directory_);
    write({{"a, \"b\"", "1.0e-16"}, {"c\nd", "none"}});
    schema_.name = "question";
    schema_.command = {"question", "--seed", "1"};
    schema_.key = {"name"};
    schema_.columns = {{"name", "", "", Exact{}}, {"error", "", "1", Rounding{{1e-10, ""}, {1e-16, ""}, 10}}};
  }
  void TearDown() override { fs::remove_all(directory_); }

  void write(const std::vector<std::vector<std::string>>& rows, const std::vector<const char*>& more = {}) {
    ResultsFile file("question", {"name", "error"});
    for (const auto& row : rows) file.add(row);
    const std::string path = csv_.string();
    std::vector<const char*> arguments{"question", "--seed", "1", "--csv", path.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    file.write(csv_, static_cast<int>(arguments.size()), arguments.data());
  }
  void set_commit(const std::string& commit) {
    std::string manifest = read_whole(manifest_of(csv_));
    const std::string key = "\"commit\": \"";
    const std::size_t from = manifest.find(key) + key.size();
    manifest.replace(from, manifest.find('"', from) - from, commit);
    write_whole(manifest_of(csv_), manifest);
  }

  fs::path directory_ = fs::temp_directory_path() / fmt::format("trivium_results_{}", ::getpid());
  fs::path csv_ = directory_ / "question.csv";
  ResultsSchema schema_;
};

TEST_F(WrittenResults, AreReadAsTheyWere) {
  const ResultsTable table = read_results(csv_);
  EXPECT_TRUE(table.intact());
  EXPECT_EQ(table.text(0, "name"), "a, \"b\"");
  EXPECT_EQ(table.text(1, "name"), "c\nd");
  EXPECT_EQ(table.number(0, "error"), 1e-16);
  EXPECT_THROW(table.number(1, "error"), ResultsError);
  EXPECT_TRUE(check_results(schema_, table).empty());
}

TEST_F(WrittenResults, ChangedDigitIsFound) {
  std::string text = read_whole(csv_);
  text[text.find("1.0e-16")] = '2';
  write_whole(csv_, text);
  const auto differences = check_results(schema_, read_results(csv_));
  ASSERT_EQ(differences.size(), 1U);
  EXPECT_EQ(differences[0].column, "manifest: csv_sha1");
}

TEST_F(WrittenResults, AreAcceptedFromACommitAlone) {
  for (const auto& [commit, refusals] :
       {std::pair{"0123456789ab", 0U}, {"0123456789ab-dirty", 1U}, {"unknown", 1U}}) {
    set_commit(commit);
    EXPECT_EQ(refusals_of({schema_}, csv_).size(), refusals) << commit;
  }
}

TEST_F(WrittenResults, OfAnotherCommandAreRefused) {
  set_commit("0123456789ab");
  schema_.command.back() = "2";
  EXPECT_EQ(refusals_of({schema_}, csv_).size(), 1U);
}

TEST_F(WrittenResults, AreTheSameWithFiguresBesideThem) {
  write({{"a", "1.0e-16"}}, {"--plot", "figures"});
  EXPECT_TRUE(check_results(schema_, read_results(csv_)).empty());
}

TEST_F(WrittenResults, AreAcceptedWithTheirManifest) {
  const fs::path into = directory_ / "accepted";
  fs::create_directories(into);
  accept(csv_, into);
  EXPECT_EQ(read_whole(into / "question.csv"), read_whole(csv_));
  EXPECT_TRUE(read_results(into / "question.csv").intact());
}

TEST(Checksum, IsSha1) { EXPECT_EQ(sha1_of("abc"), "a9993e364706816aba3e25717850c26c9cd0d89d"); }

}  // namespace
}  // namespace trivium
