#pragma once
/// Counts memory allocations, for tests which prove that an inner loop allocates nothing. A test target links
/// it by trivium_count_allocations (cmake/TriviumTargets.cmake).

namespace trivium::test {

/// Number of calls of malloc, aligned_alloc and operator new since the start of the program.
long long allocations();

}  // namespace trivium::test
