# One translation unit for each formulation in formulations/formulation_list.hpp, which is the only list of
# formulations.
set(list ${PROJECT_SOURCE_DIR}/formulations/formulation_list.hpp)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
file(STRINGS ${list} lines REGEX "^ +X\\([A-Za-z]+, __VA_ARGS__\\)")
string(REGEX MATCHALL "X\\([A-Za-z]+" trivium_formulations "${lines}")
list(TRANSFORM trivium_formulations REPLACE "X\\(" "")
if(NOT trivium_formulations)
  message(FATAL_ERROR "${list} has no TRIVIUM_FORMULATIONS that can be read")
endif()

# trivium_units_of_formulations(<variable> <template> <scalar>): generates one source for each formulation from a
# template with @formulation@, @scalar@ and @header@; <scalar> is double or Quad. <variable> receives the list of
# sources.
function(trivium_units_of_formulations variable template scalar)
  cmake_path(GET template STEM name)
  set(header scalar)
  if(scalar STREQUAL "Quad")
    set(header quad)
  endif()
  set(units)
  foreach(formulation IN LISTS trivium_formulations)
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/instances/${name}_${formulation}_${scalar}.cpp)
    configure_file(${template} ${unit} @ONLY)
    list(APPEND units ${unit})
  endforeach()
  set(${variable} ${units} PARENT_SCOPE)
endfunction()
