#pragma once
/// Owning pointers for the vectors, matrices and solvers that SUNDIALS allocates. The library's own functions
/// free them.

#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <memory>
#include <new>
#include <type_traits>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators::sundials_library {

/// The vector type of methods in double.
using StateVectorD = StateVector<double>;

/// Frees an object by the library's function for its type.
struct Destroy {
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
  void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFree(s); }
};
/// `Pointer` is one of the library's pointer types.
template <class Pointer>
using Owned = std::unique_ptr<std::remove_pointer_t<Pointer>, Destroy>;

/// The library has found no memory for something that it makes, and what it holds may be half made.
struct LibraryWithoutMemory : std::bad_alloc {};

/// Owns what the library has made. Throws LibraryWithoutMemory if this is null.
template <class Pointer>
Owned<Pointer> own(Pointer made) {
  if (made == nullptr) throw LibraryWithoutMemory();
  return Owned<Pointer>(made);
}

/// The numbers of v, not copied.
inline Eigen::Map<StateVectorD> flat(N_Vector v) { return {N_VGetArrayPointer(v), N_VGetLength_Serial(v)}; }

}  // namespace trivium::integrators::sundials_library
