/// Evaluates every engine once to check its answer, and times those whose answer is accepted.

#include "validation/cost/measurement.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <cmath>
#include <functional>
#include <memory>

#include "validation/cost/peer_translation.hpp"
#include "validation/cost/peers.hpp"
#include "validation/cost/quad_solution.hpp"
#include "validation/cost/sparse.hpp"
#include "validation/harness/timed_formulations.hpp"

namespace trivium::cost {

namespace {

/// Largest accepted relative error of an engine [-], chosen by experiment. It admits rounding in any solver
/// of the equations, and refuses a wrong translation of the scene. Engines with soft constraints are not
/// judged.
constexpr double largest_error = 1e-3;

struct Entrant {
  Measurement row;
  std::function<std::unique_ptr<Engine>()> make;
  bool is_exact = true;  ///< the engine solves the exact equations, without softening of the constraints
};

std::vector<Entrant> entrants(const TimedScene& timed, const PeerScene& peer_scene) {
  Measurement row;
  row.scene = timed.name;
  row.family = timed.family;
  row.n = timed.n;
  row.bodies = static_cast<int>(timed.scene.bodies.size());
  std::vector<Entrant> all;
  for (const std::string& formulation : TimedFormulations::names())
    for (const Refined refined : {Refined::no, Refined::yes})
      all.push_back({of_ours(row, formulation, refined), [&timed, formulation, refined] {
                       return trivium_engine(timed.scene, formulation, refined);
                     }});
  for (const Peer& peer : peers()) {
    row.engine = peer.name;
    all.push_back(
        {row, [&peer_scene, make = peer.make] { return make(peer_scene); }, peer.make != mujoco_engine});
  }
  row.formulation = "r-omega";
  for (const std::string& solver : sparse_solvers()) {
    row.engine = solver;
    all.push_back({row, [&timed, solver] { return sparse_engine(timed.scene, solver); }});
  }
  return all;
}

double kilobytes_on_heap() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / 1024;
}

/// Creates the engine and evaluates once. If the engine cannot, the result is null and the row's note says
/// why.
std::unique_ptr<Engine> try_out(Entrant& entrant, const QuadSolution& exact) {
  Measurement& row = entrant.row;
  try {
    entrant.make();  // the first engine may fill caches that stay; the heap is therefore measured with the
                     // second one
    const double before = kilobytes_on_heap();
    auto engine = entrant.make();
    engine->evaluate();
    row.kilobytes = kilobytes_on_heap() - before;
    const double seconds = seconds_of([&] { engine->evaluate(); });
    row.error = exact.error_of(engine->r_ddot());
    if (const auto lambda = engine->lambda(); !lambda.empty())
      row.lambda_error = exact.lambda_error_of(lambda);
    if (seconds > most_seconds) throw NotTaken(fmt::format("one evaluation takes {:.0f} s", seconds));
    if (entrant.is_exact && !(*row.error <= largest_error))
      throw std::runtime_error("the error of its answer is too large");
    return engine;
  } catch (const NotTaken& reason) {
    row.note = reason.what();
  } catch (const std::exception& error) {
    row.note = fmt::format("fails: {}", error.what());
    row.failed = true;
  }
  return nullptr;
}

}  // namespace

Measurement of_ours(Measurement row, const std::string& formulation, Refined refined) {
  row.engine = our_name;
  row.ours = true;
  row.formulation = formulation;
  row.refinement = refined == Refined::yes ? "refined" : "unrefined";
  return row;
}

void set_ratios(std::vector<Measurement>& rows) {
  const auto is_reference = [](const Measurement& row) {
    return row.ours && row.formulation == "r-omega" && row.refinement == "refined" && row.microseconds;
  };
  const auto reference = std::find_if(rows.begin(), rows.end(), is_reference);
  if (reference == rows.end()) return;
  const double microseconds = *reference->microseconds;
  for (Measurement& row : rows)
    if (row.microseconds) row.ratio = *row.microseconds / microseconds;
}

std::vector<Measurement> measure(const TimedScene& scene, const Timing& timing) {
  const QuadSolution exact = quad_solution(scene.scene);
  const PeerScene peer_scene = to_peers(scene.scene);
  std::vector<Entrant> all = entrants(scene, peer_scene);
  std::vector<std::unique_ptr<Engine>> engines;
  std::vector<std::function<void()>> work;
  std::vector<std::size_t> worker;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (auto engine = try_out(all[k], exact)) {
      worker.push_back(k);
      work.push_back([one = engine.get()] { one->evaluate(); });
      engines.push_back(std::move(engine));
    }
  const std::vector<double> microseconds = median_microseconds(work, timing);
  for (std::size_t k = 0; k < worker.size(); ++k) all[worker[k]].row.microseconds = microseconds[k];
  std::vector<Measurement> rows;
  for (Entrant& entrant : all) rows.push_back(std::move(entrant.row));
  set_ratios(rows);
  return rows;
}

}  // namespace trivium::cost
