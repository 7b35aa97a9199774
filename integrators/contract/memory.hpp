#pragma once
/// The memory of a method: the numbers that it keeps from step to step. Saved together with a state, they
/// allow a run with given steps, in double, to continue exactly as if it had not ended. A method with a
/// memory has `show_memory(show)`, which calls show(part...) with each part: a number S or a StateVector.
/// `begin` has set the length of each vector before. `show` is a MemorySaver or a MemoryReader.

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// Appends the parts to a list of numbers. The length of a vector is written before its elements.
template <class S>
class MemorySaver {
 public:
  explicit MemorySaver(std::vector<double>& numbers) : numbers_(numbers) {}
  void operator()(const auto&... part) const { (save(part), ...); }

 private:
  void save(const S& number) const { numbers_.push_back(static_cast<double>(number)); }
  void save(const StateVector<S>& vector) const {
    numbers_.push_back(static_cast<double>(vector.size()));
    for (const S& number : vector) save(number);
  }
  std::vector<double>& numbers_;
};

/// Reads the parts from a list of a MemorySaver. Throws a std::invalid_argument if the list does not fit the
/// method.
template <class S>
class MemoryReader {
 public:
  explicit MemoryReader(const std::vector<double>& numbers) : numbers_(numbers) {}
  void operator()(auto&... part) { (read(part), ...); }
  /// Throws if the list has more numbers than were read.
  void end() const {
    if (next_ != numbers_.size()) refuse();
  }

 private:
  void read(S& number) {
    if (next_ == numbers_.size()) refuse();
    number = S(numbers_[next_++]);
  }
  /// The vector keeps its length, which must be equal to the length in the list.
  void read(StateVector<S>& vector) {
    S size(0);
    read(size);
    if (size != S(static_cast<double>(vector.size()))) refuse();
    for (S& number : vector) read(number);
  }
  [[noreturn]] static void refuse() {
    throw std::invalid_argument("the saved numbers do not fit the memory of this method");
  }

  const std::vector<double>& numbers_;
  std::size_t next_ = 0;
};

}  // namespace trivium::integrators
