# acceleration_cost, where TRIVIUM_BUILD_BENCH asks for it (preset bench, ./run bench): our accelerations beside other
# engines, as far as these are installed, and beside general sparse solvers.
if(NOT TRIVIUM_BUILD_BENCH)
  return()
endif()
find_package(benchmark REQUIRED)

add_executable(acceleration_cost acceleration_cost.cpp simbody_translation.cpp
               cost/ensemble.cpp cost/exact.cpp cost/measurement.cpp cost/ours.cpp cost/peer_translation.cpp cost/peers.cpp
               cost/plots.cpp cost/scenes.cpp cost/sparse.cpp cost/state_sweep.cpp cost/timing.cpp)
target_link_libraries(acceleration_cost PRIVATE trivium_edge trivium_options benchmark::benchmark ${CMAKE_DL_LIBS})

# Simbody: C++17 and NDEBUG undefined, as in TriviumSimbody
if(TARGET trivium_simbody)
  add_library(trivium_cost_simbody STATIC cost/simbody_engine.cpp)
  set_target_properties(trivium_cost_simbody PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(trivium_cost_simbody PRIVATE -UNDEBUG)
  target_include_directories(trivium_cost_simbody SYSTEM PRIVATE ${Simbody_INCLUDE_DIR})
  target_link_libraries(trivium_cost_simbody PRIVATE trivium_options PUBLIC trivium_simbody)
  target_link_libraries(acceleration_cost PRIVATE trivium_cost_simbody)
  target_compile_definitions(acceleration_cost PRIVATE TRIVIUM_COST_SIMBODY)
endif()

# MuJoCo: a C interface; its CMake configuration asks for OpenGL and names a folder that is not there
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
find_library(MUJOCO_LIBRARY mujoco)
if(MUJOCO_INCLUDE_DIR AND MUJOCO_LIBRARY)
  target_sources(acceleration_cost PRIVATE cost/mujoco_engine.cpp cost/mujoco_text.cpp)
  target_include_directories(acceleration_cost SYSTEM PRIVATE ${MUJOCO_INCLUDE_DIR})
  target_link_libraries(acceleration_cost PRIVATE ${MUJOCO_LIBRARY})
  target_compile_definitions(acceleration_cost PRIVATE TRIVIUM_COST_MUJOCO)
endif()

# DART takes Eigen's objects as its distribution built them, for plain x86-64; dart_engine.cpp says why it is a module
find_package(DART 6.12 QUIET COMPONENTS dart CONFIG)
if(DART_FOUND)
  add_library(trivium_cost_dart MODULE cost/dart_engine.cpp)
  set_target_properties(trivium_cost_dart PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_VISIBILITY_PRESET hidden
                                                     VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(trivium_cost_dart PRIVATE -march=x86-64)
  target_include_directories(trivium_cost_dart PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(trivium_cost_dart PRIVATE dart)
  target_sources(acceleration_cost PRIVATE cost/dart_module.cpp)
  add_dependencies(acceleration_cost trivium_cost_dart)
  target_compile_definitions(acceleration_cost PRIVATE TRIVIUM_COST_DART="$<TARGET_FILE:trivium_cost_dart>")
endif()

# SuiteSparse has no CMake configuration of its own
find_path(SUITESPARSE_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse)
find_library(UMFPACK_LIBRARY umfpack)
find_library(KLU_LIBRARY klu)
find_library(BTF_LIBRARY btf)
if(SUITESPARSE_INCLUDE_DIR AND UMFPACK_LIBRARY AND KLU_LIBRARY AND BTF_LIBRARY)
  target_include_directories(acceleration_cost SYSTEM PRIVATE ${SUITESPARSE_INCLUDE_DIR})
  target_link_libraries(acceleration_cost PRIVATE ${UMFPACK_LIBRARY} ${KLU_LIBRARY} ${BTF_LIBRARY})
  target_compile_definitions(acceleration_cost PRIVATE TRIVIUM_COST_SUITESPARSE)
endif()
