#include "results/tools/results_writer.hpp"

#include <fmt/format.h>

#include <fstream>

#include "base/csv.hpp"
#include "base/json_writer.hpp"
#include "base/whole_file.hpp"
#include "build_info.hpp"
#include "results/tools/checksum.hpp"
#include "results/tools/results_table.hpp"

namespace trivium {

namespace fs = std::filesystem;

namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

std::string results_number(double x) { return fmt::format("{:.6e}", x); }

ResultsFile::ResultsFile(std::string name, std::vector<std::string> columns)
    : name_(std::move(name)), columns_(std::move(columns)) {}

void ResultsFile::add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

void ResultsFile::write(const fs::path& file, int argc, const char* const* argv) const {
  std::string csv = csv_line(columns_);
  for (const auto& row : rows_) csv += csv_line(row);

  std::string command = name_;  // file names without folders: independent of the machine
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    command +=
        " " + (argument.find('/') == std::string::npos ? argument : fs::path(argument).filename().string());
  }
  JsonWriter manifest;
  manifest.begin_object()
      .text("results", name_)
      .text("command", command)
      .text("csv_sha1", sha1_of(csv))
      .text("commit", build_info::commit)
      .text("compiler", build_info::compiler)
      .text("flags", build_info::flags)
      .text("build_type", build_info::build_type)
      .text("trivium", build_info::version)
      .text("eigen", build_info::eigen)
      .text("boost", build_info::boost)
      .text("simbody", build_info::simbody)
      .text("cpu", cpu_model())
      .end_object();
  write_whole(file, csv);
  write_whole(manifest_of(file), manifest.str());
}

}  // namespace trivium
