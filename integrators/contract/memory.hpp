#pragma once
/// What a method keeps from step to step, as numbers: saved with a state, they let a run go on as if it had
/// not ended. A method that has such a memory shows its parts, show(part...), to one that saves or recalls
/// them.

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// Appends parts to a list, a vector with its length in front.
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

/// Takes parts from such a list. Throws a std::invalid_argument where it is none of this method's.
template <class S>
class MemoryReader {
 public:
  explicit MemoryReader(const std::vector<double>& numbers) : numbers_(numbers) {}
  void operator()(auto&... part) { (read(part), ...); }
  /// Throws where numbers are left.
  void end() const {
    if (next_ != numbers_.size()) refuse();
  }

 private:
  void read(S& number) {
    if (next_ == numbers_.size()) refuse();
    number = S(numbers_[next_++]);
  }
  /// Of the length that it has begun with.
  void read(StateVector<S>& vector) {
    S size(0);
    read(size);
    if (size != S(static_cast<double>(vector.size()))) refuse();
    for (S& number : vector) read(number);
  }
  [[noreturn]] static void refuse() {
    throw std::invalid_argument("the numbers are not the method's memory");
  }

  const std::vector<double>& numbers_;
  std::size_t next_ = 0;
};

}  // namespace trivium::integrators
