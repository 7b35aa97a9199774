/// Question: where does each formulation and method hold, and where does it say that it does not? A case
/// survives if its error stays below its threshold, and announces itself if an error or a warning says what
/// is wrong. The program fails if a case does neither (validation/hard/).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <optional>

#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "formulations/formulation_list.hpp"
#include "results/tools/results_table.hpp"
#include "scenes/format/scene_file.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/methods.hpp"
#include "validation/hard/parallel.hpp"
#include "validation/harness/program.hpp"

namespace trivium::hard {

namespace {

struct Arguments {
  std::vector<std::string> families, formulations, cases;
  std::string scene, program;
  bool is_quick = false, lists = false;
};

/// One case at one difficulty.
struct Task {
  const Family* family;
  const Case* of;
  double difficulty;
  bool is_twin;

  std::string name() const {
    return fmt::format("{} {:g}{}", of->name, difficulty, is_twin ? " (easy)" : "");
  }
};

std::string text_of(const Accepted& accepted) {
  return fmt::format("{}{:g} to {:g}", accepted.is_count ? "whole numbers from " : "", accepted.least,
                     accepted.most);
}

/// The case and the difficulty that an option asks for as NAME=DIFFICULTY.
Task read_task(const std::vector<Family>& all, const std::string& option, const std::string& text) {
  const std::size_t at = text.find('=');
  const double difficulty = at == text.npos ? to_number("") : to_number(text.substr(at + 1));
  if (!std::isfinite(difficulty))
    throw Error(ErrorKind::input, fmt::format("{}: found {}; accepted: NAME=NUMBER", option, text));
  const std::string name = text.substr(0, at);
  std::vector<std::string> names;
  for (const Family& family : all)
    for (const Case& one : family.cases) {
      names.push_back(one.name);
      if (one.name != name) continue;
      const bool is_twin = difficulty == one.easy;
      if (!is_twin && !one.accepted.includes(difficulty))
        throw Error(ErrorKind::input, fmt::format("{}: found {}; accepted for {}: {}, and its easy twin {:g}",
                                                  option, text, name, text_of(one.accepted), one.easy));
      return {&family, &one, difficulty, is_twin};
    }
  throw Error(ErrorKind::input,
              fmt::format("{}: found {}; accepted: {}", option, name, fmt::join(names, ", ")));
}

std::vector<Task> tasks_of(const std::vector<Family>& all, const Arguments& arguments) {
  std::vector<Task> tasks;
  for (const std::string& text : arguments.cases) tasks.push_back(read_task(all, "--case", text));
  if (!tasks.empty()) return tasks;
  for (const Family& family : all) {
    const auto& wanted = arguments.families;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), family.name) == wanted.end()) continue;
    for (const Case& one : family.cases) {
      tasks.push_back({&family, &one, one.easy, true});
      for (const double difficulty : arguments.is_quick ? one.quick : one.whole)
        tasks.push_back({&family, &one, difficulty, false});
    }
  }
  return tasks;
}

std::vector<Row> rows_of(const Task& task, const Choice& choice) {
  Judge judge(task.family->name, task.name(), task.is_twin, choice);
  try {
    if (!task.is_twin && !task.of->accepted.includes(task.difficulty))
      throw Error(ErrorKind::input, "this difficulty is listed, but not accepted");
    if (task.of->scene)
      scenes::write_scene(task.of->scene(task.difficulty));  // other programs must accept it
    task.of->judge(judge, task.difficulty);
  } catch (const std::exception& error) {
    Row row = judge.row("-", "-", "the case itself");
    row.verdict = Verdict::fails;
    row.why = error.what();
    judge.add(row);
  }
  return judge.rows();
}

std::string number(double x) { return std::isfinite(x) ? fmt::format("{:.1e}", x) : "none"; }

/// A line for a terminal; --json and --csv have the whole text.
std::string shortened(const std::string& why) {
  constexpr std::size_t most = 100;
  return why.size() <= most ? why : why.substr(0, why.rfind(' ', most)) + " ...";
}

std::string summary(const long (&count)[4]) {
  return fmt::format("{} survive, {} announce themselves, {} are not judged, {} fail\n", count[0], count[1],
                     count[2], count[3]);
}

std::string text(const std::vector<Row>& rows, const std::vector<Family>& all) {
  std::string out;
  long sum[4] = {};
  int blocks = 0;
  for (const Family& family : all) {
    Table table({"case", "formulation", "method", "monitored", "value", "amplification", "threshold",
                 "verdict", "why"},
                true);
    long count[4] = {};
    bool has_rows = false;
    for (const Row& row : rows) {
      if (row.family != family.name) continue;
      has_rows = true;
      if (row.counts) ++count[static_cast<int>(row.verdict)];
      table.add({row.name, row.formulation, row.method, row.quantity, number(row.value),
                 number(row.amplification), number(row.threshold), verdict_of(row), shortened(row.why)});
    }
    if (!has_rows) continue;
    ++blocks;
    for (int verdict = 0; verdict < 4; ++verdict) sum[verdict] += count[verdict];
    out += fmt::format("{}: {}\n{}{}\n", family.name, family.about, table.text(), summary(count));
  }
  return blocks > 1 ? out + "all families: " + summary(sum) : out;
}

const std::vector<std::string> columns{"family",    "case",    "formulation", "method",
                                       "quantity",  "value",   "tolerance",   "amplification",
                                       "threshold", "verdict", "why"};

std::vector<std::string> fields(const Row& r) {
  const auto known = [](double x) { return std::isfinite(x) ? results_number(x) : "none"; };
  return {r.family,
          r.name,
          r.formulation,
          r.method,
          r.quantity,
          known(r.value),
          known(r.tolerance),
          known(r.amplification),
          known(r.threshold),
          verdict_of(r),
          r.why};
}

std::string json(const std::vector<Row>& rows, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("rows");
  for (const Row& r : rows) {
    out.begin_object()
        .text("family", r.family)
        .text("case", r.name)
        .text("formulation", r.formulation)
        .text("method", r.method)
        .text("quantity", r.quantity);
    if (std::isfinite(r.value))
      out.number("value", r.value)
          .number("tolerance", r.tolerance)
          .number("amplification", r.amplification)
          .number("threshold", r.threshold);
    out.text("verdict", name_of(r.verdict)).flag("counts", r.counts).text("why", r.why).end_object();
  }
  return out.end_array().end_object().str();
}

bool has_case(const Family& family, const std::string& name) {
  return std::any_of(family.cases.begin(), family.cases.end(),
                     [&](const Case& one) { return one.name == name; });
}

int list(const std::vector<Family>& all) {
  for (const Family& family : all) {
    fmt::print("{}: {}\n", family.name, family.about);
    for (const Case& one : family.cases)
      fmt::print("  {:<24} {}; easy {:g}, quick {}, whole {}, accepted {}\n", one.name, one.difficulty,
                 one.easy, fmt::join(one.quick, " "), fmt::join(one.whole, " "), text_of(one.accepted));
    for (const WithoutSimbody& without : cases_without_simbody())
      if (without.of == family.name || has_case(family, without.of))
        fmt::print("  {:<24} no rows: {}\n",
                   without.of == family.name ? "Simbody" : "Simbody in " + without.of, without.why);
    for (const MethodsOfFamily& methods : method_list()) {
      const bool is_part = methods.of.starts_with(family.name + "/");
      const std::string part = is_part ? methods.of.substr(family.name.size() + 1) : methods.of;
      if (is_part || part == family.name || has_case(family, part))
        fmt::print("  methods{} {}: {}\n",
                   part == family.name ? std::string(17, ' ') : fmt::format(" of {:<13}", part),
                   fmt::join(methods.whole, ", "), methods.why);
    }
  }
  return exit_done;
}

int run(const Program& program, const Arguments& arguments) {
  const std::vector<Family> all = families();
  if (arguments.lists) return list(all);
  if (!arguments.scene.empty()) {
    const Task task = read_task(all, "--scene", arguments.scene);
    if (!task.of->scene)
      throw Error(ErrorKind::input, fmt::format("--scene: {} is not a single scene", task.of->name));
    fmt::print("{}", scenes::write_scene(task.of->scene(task.difficulty)));
    return exit_done;
  }
  if (!arguments.cases.empty() && !arguments.families.empty())
    throw Error(ErrorKind::input,
                "--family: found beside --case, which names its family; accepted: one of them");
  const std::vector<Task> tasks = tasks_of(all, arguments);
  Choice choice{arguments.is_quick, arguments.formulations, arguments.program};
  if (std::error_code none;
      !choice.program.empty() && !std::filesystem::is_regular_file(choice.program, none))
    throw Error(ErrorKind::input,
                fmt::format("--program: found {}, which is no file; accepted: the path of the "
                            "program `trivium`",
                            choice.program));
  if (choice.program.empty())
    choice.program = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "trivium").string();
  Progress progress("hard_cases", tasks.size());
  std::vector<std::vector<Row>> found(tasks.size());
  in_parallel(
      tasks.size(), [&](std::size_t k) { found[k] = rows_of(tasks[k], choice); }, [&] { progress.step(); });
  std::vector<Row> rows;
  for (const auto& some : found) rows.insert(rows.end(), some.begin(), some.end());
  ResultsFile file("hard_cases", columns);
  for (const Row& row : rows) file.add(fields(row));
  program.write(file);
  const bool passed = std::none_of(rows.begin(), rows.end(),
                                   [](const Row& r) { return r.counts && r.verdict == Verdict::fails; });
  fmt::print("{}", program.json() ? json(rows, passed) : text(rows, all));
  return batch_exit(true, passed);
}

}  // namespace

}  // namespace trivium::hard

int main(int argc, char** argv) {
  using namespace trivium;
  Program program(
      "Where does each formulation and method hold, and where does it say that it does not? Runs families of "
      "hard cases; each survives, announces itself, or FAILS.",
      "hard_cases", "");
  hard::Arguments arguments;
  std::vector<std::string> names;
  for (const hard::Family& family : hard::families()) names.push_back(family.name);
  ProgramOptions& options = program.options();
  options.add_flag("--quick", &arguments.is_quick, "A few cases of every family, in less than two minutes");
  options.add_option("--family", &arguments.families, "Only this family; may be repeated")
      .may_repeat("FAMILY")
      .one_of(names);
  options.add_option("--formulation", &arguments.formulations, "Only this formulation; may be repeated")
      .may_repeat("FORMULATION")
      .one_of(formulation_names());
  options.add_option("--case", &arguments.cases, "Only this case, at any difficulty; may be repeated")
      .may_repeat("NAME=DIFFICULTY");
  options.add_option("--scene", &arguments.scene, "Print the scene of a case, as NAME=DIFFICULTY, and end");
  options.add_flag("--list", &arguments.lists, "List the cases and the methods of each family, and end");
  options.add_option("--program", &arguments.program,
                     "The program `trivium` of the family of faults (default: beside this program)");
  return program.run(argc, argv, [&] { return hard::run(program, arguments); });
}
