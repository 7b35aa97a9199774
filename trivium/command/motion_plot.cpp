/// Collects the numbers of a figure as text, one line per output, and writes the script with which gnuplot
/// draws them.

#include "trivium/command/motion_plot.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/gnuplot.hpp"

namespace trivium {

std::vector<std::size_t> MotionPlot::shown(std::size_t count) {
  constexpr std::size_t most = 4;
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < std::min(count, most - 1); ++k) out.push_back(k);
  if (count >= most) out.push_back(count - 1);
  return out;
}

MotionPlot::MotionPlot(const Mechanism<double>& mechanism, std::string title)
    : title_(std::move(title)),
      bodies_(mechanism.body_names.begin(), mechanism.body_names.end() - 1),
      shown_bodies_(shown(bodies_.size())),
      shown_joints_(shown(mechanism.joints.size())) {
  for (const Joint<double>& joint : mechanism.joints) joints_.push_back(joint.name);
}

void MotionPlot::add(const MotionSample& sample) {
  if (samples_++ == 0) first_energy_ = sample.energy;
  data_ += fmt::format("{:.9g}", sample.state.t);
  for (const std::size_t b : shown_bodies_)
    for (const double x : sample.state.pose[b].r) data_ += fmt::format(" {:.9g}", x);
  for (const std::size_t k : shown_joints_) data_ += fmt::format(" {:.9g}", sample.reactions[k].force.norm());
  data_ += fmt::format(" {:.9g} {:.3g} {:.3g}\n", std::abs(sample.energy - first_energy_), sample.phi,
                       sample.phi_dot);
}

void MotionPlot::write(const std::string& file) const {
  int column = 2;
  std::vector<std::string> places, forces, errors;
  if (samples_ < 2) return;  // no line to draw
  const auto curve = [&](const std::string& name, std::size_t colour, std::size_t dashes = 0,
                         const char* value = "${}") {
    return fmt::format("$motion using 1:({}) with lines lw 1.5 lc {} dt {} title {}",
                       fmt::format(fmt::runtime(value), column++), colour + 1, dashes + 1,
                       gnuplot_quoted(name));
  };
  // one colour per body, one dash pattern per axis
  for (std::size_t n = 0; n < shown_bodies_.size(); ++n)
    for (std::size_t axis = 0; axis < 3; ++axis)
      places.push_back(curve(bodies_[shown_bodies_[n]] + "." + "xyz"[axis], n, axis));
  for (std::size_t n = 0; n < shown_joints_.size(); ++n)
    forces.push_back(curve(joints_[shown_joints_[n]], n));
  for (const char* name : {"|E - E(0)| [J]", "phi [m, rad]", "phi' [m/s, rad/s]"})
    errors.push_back(curve(name, errors.size(), 0, "${0} > 1e-20 ? ${0} : 1e-20"));  // logarithmic axis
  const auto panel = [](const std::vector<std::string>& curves, const std::string& label) {
    if (curves.empty()) return std::string("set multiplot next\n");
    return fmt::format("set ylabel {}\nplot {}\n", gnuplot_quoted(label), fmt::join(curves, ", \\\n  "));
  };
  run_gnuplot(
      fmt::format(
          "$motion << EOD\n{}EOD\n"
          "set terminal svg size 900,1000 noenhanced font 'sans,12' background '#ffffff'\nset output {}\n"
          "set multiplot layout 3,1 title {}\nset grid\nset lmargin 12\nset rmargin 26\n"
          "set key at screen 0.99, graph 1 right top\nset xlabel 't [s]'\n{}{}"
          "set logscale y\nset format y '%.0e'\n{}unset multiplot\n",
          data_, gnuplot_quoted(file), gnuplot_quoted(title_), panel(places, "position [m]"),
          panel(forces, "joint force [N]"), panel(errors, "violations, change of energy")),
      file);
}

}  // namespace trivium
