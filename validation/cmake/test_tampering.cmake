cmake_minimum_required(VERSION 3.25)
# Changes one number of an accepted CSV, and of a generated table, and expects the checks to fail: with exit code 1,
# since a check that merely broke would prove nothing.
#   COMPARE, TABLES   the executables          RESULTS, PAPER_TABLES   accepted results, committed tables
#   REGENERATED       results made again       WORK                    a folder to write in

# Writes FILE to COPY with the first match of PATTERN replaced.
function(tamper file copy pattern replacement)
  file(READ ${file} text)
  string(REGEX MATCH "${pattern}" found "${text}")
  if(found STREQUAL "")
    message(FATAL_ERROR "${file} has nothing like ${pattern}")
  endif()
  string(REGEX REPLACE "${pattern}" "${replacement}" changed "${found}")
  string(FIND "${text}" "${found}" at)
  string(LENGTH "${found}" length)
  math(EXPR behind "${at} + ${length}")
  string(SUBSTRING "${text}" 0 ${at} head)
  string(SUBSTRING "${text}" ${behind} -1 tail)
  file(WRITE ${copy} "${head}${changed}${tail}")
endfunction()

function(expect exit_code what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL exit_code)
    message(FATAL_ERROR "${what}: exit code ${result} instead of ${exit_code}\n${output}")
  endif()
  message(STATUS "${what}: ${exit_code}, as it should be")
endfunction()

# Two ways to change a number: by a factor of 10^4, which its rule must see, and in its last digit, which only the
# checksum can.
set(exponent "([0-9]\\.[0-9]+e-)1([4-9])" "\\10\\2")
set(digit "([0-9]\\.[0-9]+)[0-8](e-[0-9]+)" "\\19\\2")

file(REMOVE_RECURSE ${WORK})
file(GLOB files ${RESULTS}/*.csv)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  set(compare ${COMPARE} ${WORK}/results/${name}.csv ${REGENERATED}/${name}.csv --schema ${RESULTS}/schema.json)
  foreach(change IN ITEMS exponent digit)
    file(COPY ${RESULTS}/ DESTINATION ${WORK}/results)
    expect(0 "${name}, as accepted" ${compare})
    tamper(${file} ${WORK}/results/${name}.csv ${${change}})
    expect(1 "${name}, one ${change} changed" ${compare})
    expect(2 "tables from ${name}, one ${change} changed" ${TABLES} ${WORK}/results ${PAPER_TABLES} --check)
    file(REMOVE_RECURSE ${WORK}/results)
  endforeach()
endforeach()

file(GLOB tables ${PAPER_TABLES}/*.tex)
foreach(table IN LISTS tables)
  get_filename_component(name ${table} NAME)
  file(COPY ${PAPER_TABLES}/ DESTINATION ${WORK}/tables)
  expect(0 "tables, as committed" ${TABLES} ${RESULTS} ${WORK}/tables --check)
  tamper(${table} ${WORK}/tables/${name} "([0-9]\\.)[0-8](e-[0-9]+)" "\\19\\2")
  expect(1 "${name}, one digit changed" ${TABLES} ${RESULTS} ${WORK}/tables --check)
  file(REMOVE_RECURSE ${WORK}/tables)
endforeach()
