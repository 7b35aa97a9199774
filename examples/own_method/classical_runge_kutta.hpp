#pragma once
/// A user-written integration method: the classical Runge-Kutta method of order 4 with given steps h.
///
///   k_1 = f(t, y),              k_2 = f(t + h/2, y + h/2 k_1)
///
///   k_3 = f(t + h/2, y + h/2 k_2),   k_4 = f(t + h, y + h k_3)
///
///   y_n+1 = y_n + h/6 (k_1 + 2 k_2 + 2 k_3 + k_4)

#include <integrators/method_entry.hpp>

class ClassicalRungeKutta {
 public:
  using Y = trivium::integrators::StateVector<double>;

  template <trivium::integrators::FirstOrderSystem System>
  void step(System& system, double& t, Y& y, const double& stop) {
    const double h = stop - t;
    system.derivative(t, y, k_1_);
    system.derivative(t + h / 2, y + h / 2 * k_1_, k_2_);
    system.derivative(t + h / 2, y + h / 2 * k_2_, k_3_);
    system.derivative(stop, y + h * k_3_, k_4_);
    y += h / 6 * (k_1_ + 2 * k_2_ + 2 * k_3_ + k_4_);
    t = stop;
    ++counters_.steps;
    counters_.right_sides += 4;
  }
  void restart() { ++counters_.restarts; }  // the method keeps nothing from step to step
  bool shorten() { return false; }          // steps are given and cannot be shortened
  const trivium::integrators::Counters& counters() const { return counters_; }

 private:
  Y k_1_, k_2_, k_3_, k_4_;
  trivium::integrators::Counters counters_;
};

inline trivium::integrators::MethodEntry<double> classical_runge_kutta() {
  return {{.name = "rk4",
           .summary = "Runge and Kutta's classical formula",
           .order = 4,
           .takes_given_steps = true},
          [](const trivium::integrators::MethodRequest&) {
            return trivium::integrators::adapt<double>(ClassicalRungeKutta());
          }};
}
