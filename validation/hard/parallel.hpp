#pragma once
/// Works through numbered tasks with as many threads as the machine has cores. The order of results is that
/// of the numbers, whatever the order of the work.

#include <functional>

namespace trivium::hard {

/// Calls work(k) once for every k below `count`, in any order, and `done` after each of them, one thread at a
/// time. Throws the first exception of a task, after all threads have ended.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work,
                 const std::function<void()>& done);

}  // namespace trivium::hard
