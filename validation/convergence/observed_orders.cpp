/// Runs a method at successively halved steps, in double or quad, and computes its errors at half time and at
/// the end.

#include "validation/convergence/observed_orders.hpp"

#include <algorithm>
#include <limits>

#include "base/command_line.hpp"
#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::convergence {

namespace {

/// Like Case::floor, for methods that compute in double: about 100 u.
constexpr double floor_in_double = 1e-14;

Errors floors_of(const std::vector<MotionSample>& exact, double share) {
  Errors size{};
  for (const MotionSample& sample : exact) {
    for (const Pose<double>& pose : sample.state.pose) size[0] = std::max({size[0], pose.r.norm(), 1.0});
    for (const Twist<double>& twist : sample.state.twist)
      size[1] = std::max({size[1], twist.r_dot.norm(), twist.omega_bar.norm()});
    size[2] = size[3] = std::max(size[2], sample.lambda.norm());
  }
  for (double& x : size) x *= share;
  return size;
}

/// The largest error of each quantity over the outputs. Both samples are doubles plus a rest (state_rest,
/// lambda_rest), which keeps the digits of a run in quad.
Errors errors_of(const std::vector<MotionSample>& found, const std::vector<MotionSample>& exact) {
  Errors e{};
  const auto raise = [&](int quantity, double error) { trivium::raise(e[quantity], error); };
  const auto rest = [](const MotionSample& sample, const auto& part) {
    return sample.state_rest ? part(*sample.state_rest) : decltype(part(*sample.state_rest))::Zero().eval();
  };
  for (std::size_t k = 0; k < exact.size(); ++k) {
    // p and -p are the same orientation
    const auto apart = [&](const auto& part, double sign = 1) {
      return ((part(found[k].state) - sign * part(exact[k].state)) +
              (rest(found[k], part) - sign * rest(exact[k], part)))
          .norm();
    };
    for (std::size_t b = 0; b < exact[k].state.pose.size(); ++b) {
      const auto p = [&](const MechanismState<double>& s) { return Vector4<double>(s.pose[b].p); };
      raise(0, apart([&](const MechanismState<double>& s) { return Vector3<double>(s.pose[b].r); }));
      raise(0, 2 * std::min(apart(p), apart(p, -1)));
      raise(1, apart([&](const MechanismState<double>& s) { return Vector3<double>(s.twist[b].r_dot); }));
      raise(1, apart([&](const MechanismState<double>& s) { return Vector3<double>(s.twist[b].omega_bar); }));
    }
    const auto off = [&](const VectorX<double>& lambda, const VectorX<double>& lambda_rest) {
      VectorX<double> difference = lambda - exact[k].lambda;
      if (lambda_rest.size() > 0) difference += lambda_rest;
      return (difference - exact[k].lambda_rest).norm();
    };
    raise(2, off(found[k].lambda, found[k].lambda_rest));
    raise(3, found[k].raw_lambda.size() > 0 ? off(found[k].raw_lambda, found[k].raw_lambda_rest)
                                            : std::numeric_limits<double>::quiet_NaN());
  }
  return e;
}

}  // namespace

TwoModels::TwoModels(const NamedScene& of) : named(of), in_quad(make_model<Quad>(of.scene, Quad(of.t))) {}

/// The outputs at half time and at the end: an error that passes through zero at one of them does not at the
/// other.
std::vector<MotionSample> outputs_of(const TwoModels& models, SimulationOptions options, bool is_double) {
  options.output_step = options.end / 2;
  Samples samples;
  is_double ? simulate(models.named.model(), options, samples) : simulate(models.in_quad, options, samples);
  samples.all.erase(samples.all.begin());
  return samples.all;
}

OrderResult measure(const TwoModels& models, const std::string& formulation, const Case& of, double t_end,
                    int levels, const std::vector<MotionSample>& exact) {
  OrderResult row{models.named.scene.name,
                  formulation,
                  "",
                  of,
                  {},
                  {},
                  floors_of(exact, of.is_double ? floor_in_double : of.floor)};
  try {
    SimulationOptions options;
    options.formulation = formulation;
    options.integrator = of.method;
    options.parameters = of.parameters;
    options.end = t_end;
    for (int level = 0; level < levels; ++level) {
      row.h.push_back(t_end / (of.steps << level));
      options.step = row.h.back();
      row.errors.push_back(errors_of(outputs_of(models, options, of.is_double), exact));
    }
  } catch (const std::runtime_error& error) {
    row.error = name_source(models.named.source, error.what());
  }
  return row;
}

}  // namespace trivium::convergence
