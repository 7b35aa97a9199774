cmake_minimum_required(VERSION 3.25)
# Changes one number of an accepted CSV, and of a generated table, and expects the checks to fail with the right exit
# code: a check that merely crashes proves nothing.
#   COMPARE, TABLES   the executables          RESULTS, PAPER_TABLES   accepted results, committed tables
#   REGENERATED       results made again       WORK                    a folder to write in

# tamper(<file> <copy> <pattern> <replacement>...): writes the file to <copy> with one number changed. The first pattern
# that occurs in the file is used; its first match is replaced.
function(tamper file copy)
  file(READ ${file} text)
  set(changes ${ARGN})
  set(found "")
  while(found STREQUAL "" AND changes)
    list(POP_FRONT changes pattern replacement)
    string(REGEX MATCH "${pattern}" found "${text}")
  endwhile()
  if(found STREQUAL "")
    message(FATAL_ERROR "${file} has no number to change")
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

# A number is changed in two ways. The first change must violate the rule of its column: a rounding error becomes 10^10 times
# as large, a count or a time gets another leading digit. The second changes the last digit, which only the checksum detects.
# Files of timings are not made again; for them only the checksum is tested.
set(exponent "([0-9]\\.[0-9]+e-)1([4-9])" "\\10\\2" ",[1-4]([0-9][0-9]+)(,|\n)" ",9\\1\\2"
    ",[1-4](\\.[0-9]+e)" ",9\\1")
set(digit "([0-9]\\.[0-9]+)[0-8](e-[0-9]+)" "\\19\\2" ",([0-9]+)[0-8](,|\n)" ",\\19\\2")

file(REMOVE_RECURSE ${WORK})
file(GLOB files ${RESULTS}/*.csv)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  set(compare ${COMPARE} ${WORK}/results/${name}.csv ${REGENERATED}/${name}.csv --schema ${RESULTS}/schema.json)
  foreach(change IN ITEMS exponent digit)
    file(COPY ${RESULTS}/ DESTINATION ${WORK}/results)
    if(EXISTS ${REGENERATED}/${name}.csv)
      expect(0 "${name}, as accepted" ${compare})
    endif()
    tamper(${file} ${WORK}/results/${name}.csv ${${change}})
    if(EXISTS ${REGENERATED}/${name}.csv)
      expect(1 "${name}, one ${change} changed" ${compare})
    endif()
    expect(2 "tables from ${name}, one ${change} changed" ${TABLES} ${WORK}/results ${PAPER_TABLES} --check)
    file(REMOVE_RECURSE ${WORK}/results)
  endforeach()
endforeach()

file(GLOB tables ${PAPER_TABLES}/*.tex)
foreach(table IN LISTS tables)
  get_filename_component(name ${table} NAME)
  file(COPY ${PAPER_TABLES}/ DESTINATION ${WORK}/tables)
  expect(0 "tables, as committed" ${TABLES} ${RESULTS} ${WORK}/tables --check)
  tamper(${table} ${WORK}/tables/${name} "([0-9]\\.)[0-8](e-[0-9]+)" "\\19\\2" "([0-9])[0-8]([^0-9.])" "\\19\\2")
  expect(1 "${name}, one digit changed" ${TABLES} ${RESULTS} ${WORK}/tables --check)
  file(REMOVE_RECURSE ${WORK}/tables)
endforeach()
