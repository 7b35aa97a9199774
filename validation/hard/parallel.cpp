#include "validation/hard/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace trivium::hard {

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work,
                 const std::function<void()>& done) {
  std::atomic<std::size_t> next = 0;
  std::mutex guard;
  std::exception_ptr failure;
  const auto take = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      std::exception_ptr caught;
      try {
        work(k);
      } catch (...) {
        caught = std::current_exception();
      }
      const std::lock_guard lock(guard);
      if (caught && !failure) failure = caught;
      done();
    }
  };
  std::vector<std::thread> threads;
  for (unsigned n = 0; n < std::max(1u, std::thread::hardware_concurrency()); ++n) threads.emplace_back(take);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace trivium::hard
