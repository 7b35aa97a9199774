/// A shared library for LD_PRELOAD: memory that runs out at a chosen allocation, for the family of faults
/// (losses.cpp). It counts the allocations of the program from the call of main on, since nothing can catch a
/// failure before. The environment says which of them return null, from the first to the last number, and
/// which file gets the count at exit. For glibc, whose own functions do the other allocations.

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

using Main = int (*)(int, char**, char**);

Main main_of_program = nullptr;
std::atomic<bool> has_begun{false};
std::atomic<unsigned long> count{0};
unsigned long first = 0, last = 0;  ///< numbers of the failing allocations, counted from 1; 0: none

bool fails() {
  if (!has_begun) return false;
  const unsigned long number = ++count;
  if (number < first || number > last) return false;
  errno = ENOMEM;
  return true;
}

unsigned long number_of(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::strtoul(text, nullptr, 10);
}

int counted_main(int argc, char** argv, char** environment) {
  first = number_of("TRIVIUM_FIRST_FAILING_ALLOCATION");
  last = number_of("TRIVIUM_LAST_FAILING_ALLOCATION");
  has_begun = true;
  return main_of_program(argc, argv, environment);
}

/// Writes the count without an allocation.
__attribute__((destructor)) void write_count() {
  const char* file = std::getenv("TRIVIUM_ALLOCATION_COUNT_FILE");
  if (file == nullptr) return;
  char digits[24];
  char* begin = digits + sizeof digits;
  unsigned long rest = count;
  do *--begin = static_cast<char>('0' + rest % 10);
  while ((rest /= 10) != 0);
  const int descriptor = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (descriptor < 0) return;
  if (write(descriptor, begin, static_cast<std::size_t>(digits + sizeof digits - begin)) < 0) unlink(file);
  close(descriptor);
}

}  // namespace

extern "C" {

/// The C library calls main by this function, after the constructors of all libraries.
int __libc_start_main(Main program, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loader_fini)(), void* stack_end) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  main_of_program = program;
  return start(counted_main, argc, argv, init, fini, loader_fini, stack_end);
}

void* malloc(std::size_t size) noexcept { return fails() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t n, std::size_t size) noexcept { return fails() ? nullptr : __libc_calloc(n, size); }
void* realloc(void* block, std::size_t size) noexcept {
  return fails() ? nullptr : __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return fails() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  if (fails()) return ENOMEM;
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}

}  // extern "C"
