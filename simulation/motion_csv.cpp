/// Turns samples into lines of numbers. The lines go to a temporary file that replaces the named file at the
/// end, so that a run that fails does not destroy an earlier result.

#include "simulation/motion_csv.hpp"

#include "base/csv.hpp"

#include <fmt/format.h>

namespace trivium {

std::vector<std::string> motion_columns(const Mechanism<double>& mechanism, bool has_raw_lambda) {
  std::vector<std::string> names{"t"};
  for (int b = 0; b < mechanism.nb(); ++b)
    for (const char* part : {"x", "y", "z", "e0", "e1", "e2", "e3", "vx", "vy", "vz", "wx", "wy", "wz"})
      names.push_back(mechanism.body_names[b] + "." + part);
  for (const Joint<double>& joint : mechanism.joints)
    for (const char* part : {"fx", "fy", "fz", "tx", "ty", "tz"}) names.push_back(joint.name + "." + part);
  for (int k = 0; k < mechanism.nc(); ++k) names.push_back(fmt::format("lambda[{}]", k));
  for (const char* name : {"energy", "phi", "phi_dot"}) names.emplace_back(name);
  if (has_raw_lambda)
    for (int k = 0; k < mechanism.nc(); ++k) names.push_back(fmt::format("raw_lambda[{}]", k));
  return names;
}

std::vector<double> motion_numbers(const MotionSample& sample, bool has_raw_lambda) {
  std::vector<double> numbers;
  const auto put = [&](const auto& v) { numbers.insert(numbers.end(), v.begin(), v.end()); };
  numbers.push_back(sample.state.t);
  for (std::size_t b = 0; b < sample.state.pose.size(); ++b) {
    put(sample.state.pose[b].r);
    put(sample.state.pose[b].p);
    put(sample.state.twist[b].r_dot);
    put(sample.state.twist[b].omega_bar);
  }
  for (const Reaction<double>& reaction : sample.reactions) {
    put(reaction.force);
    put(reaction.torque);
  }
  put(sample.lambda);
  numbers.insert(numbers.end(), {sample.energy, sample.phi, sample.phi_dot});
  // at the start and after a restart a method has computed no raw lambda: lambda of (q, v) is written instead
  if (has_raw_lambda) put(sample.raw_lambda.size() > 0 ? sample.raw_lambda : sample.lambda);
  return numbers;
}

namespace {

/// The file that the path names, after links are followed.
std::filesystem::path target_of(const std::string& path) {
  const auto target = file_to_write(path);
  if (!target)
    throw std::filesystem::filesystem_error("not a regular file", path,
                                            std::make_error_code(std::errc::invalid_argument));
  return *target;
}

}  // namespace

MotionCsv::MotionCsv(const Mechanism<double>& mechanism, bool has_raw_lambda, const std::string& file)
    : name_(file), file_(target_of(file)), has_raw_lambda_(has_raw_lambda) {
  file_.write(csv_line(motion_columns(mechanism, has_raw_lambda)));
}

bool MotionCsv::add(const MotionSample& sample) {
  MotionSample shown = sample;
  p_.resize(sample.state.pose.size(), Vector4<double>::Zero());
  for (std::size_t b = 0; b < p_.size(); ++b) {
    Vector4<double>& p = shown.state.pose[b].p;
    if (p.dot(p_[b]) < 0) p = -p;
    p_[b] = p;
  }
  std::string line;
  for (const double x : motion_numbers(shown, has_raw_lambda_))
    line += fmt::format("{}{:.17g}", line.empty() ? "" : ",", x);
  return file_.write(line + "\n");
}

void MotionCsv::keep() {
  const std::error_code reason = file_.keep();
  if (!reason) return;
  std::string what = fmt::format("cannot write {}: {}", name_, reason.message());
  if (std::filesystem::exists(file_.incomplete()))
    what += fmt::format("; the lines that could be written are in {}", file_.incomplete().string());
  throw std::runtime_error(what);
}

}  // namespace trivium
