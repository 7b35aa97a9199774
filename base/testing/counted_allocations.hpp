#pragma once
/// How often a program has asked for memory. A support of tests that count it; trivium_count_allocations
/// (cmake/TriviumTargets.cmake) links it in.

namespace trivium::test {

/// Calls of malloc, aligned_alloc and operator new since the program began.
long long allocations();

}  // namespace trivium::test
