cmake_minimum_required(VERSION 3.25)
# cmake/docs_pages.sh passes a page whose outputs are real, and finds each kind of page that is not.
#   BIN   the folder of the programs     SOURCE_DIR   the sources     WORK   a folder to work in
file(MAKE_DIRECTORY ${WORK})
set(output "r-omega           11        48    39.67")

# expect(<result> <pattern> <text>): a page with this text passes (0) or fails (1), and the script prints the pattern
function(expect result pattern text)
  file(WRITE ${WORK}/page.md "${text}")
  execute_process(COMMAND ${SOURCE_DIR}/cmake/docs_pages.sh ${BIN} ${SOURCE_DIR} ${WORK}/pages ${WORK}/page.md
                  RESULT_VARIABLE found OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  if(NOT found EQUAL result OR NOT printed MATCHES "${pattern}")
    message(FATAL_ERROR "exit code ${found} instead of ${result}, or no \"${pattern}\" in:\n${printed}\nfor the page:\n${text}")
  endif()
endfunction()

set(command "```sh\n./run check simple_pendulum | grep '^r-omega '\n```\n")
expect(0 "^$" "${command}\n```text\n${output}\n```\n")
string(REPLACE 39.67 39.66 close "${output}")
expect(0 "^$" "${command}\n```text\n${close}\n```\n")
string(REPLACE 39.67 43 far "${output}")
expect(1 "page.md:7: the output is another.*line 1 shows" "${command}\n```text\n${far}\n```\n")
string(REPLACE r-omega r-p other "${output}")
expect(1 "the output is another" "${command}\n```text\n${other}\n```\n")
expect(1 "the output is another" "${command}\n```text\n${output}\none line more\n```\n")
expect(1 "the output is another" "${command}\n```text\n```\n")
expect(1 "failed: ./run check no_such_scene" "```sh\n./run check no_such_scene\n```\n")
expect(1 "failed: ./run check no_such_scene" "```sh\n./run check no_such_scene | head -n 1\n```\n")
expect(1 "--steps is no option of" "```sh\n./run simulate heavy_top --steps 1\n```\n")
expect(1 "no program has the option" "Use `--stepp`.\n")
expect(1 "run has no command ornament|there is no command" "```sh\n./run ornament\n```\n")
expect(1 "this is not the output of: echo a" "<!-- output of: echo a -->\nb\n<!-- end -->\n")
expect(1 "the last block does not end" "```sh\n./run list\n")
# numbers that are rounding, times, and counts beside times
set(rounding "```sh\n./run check simple_pendulum | grep 'position violation'\n```\n")
expect(1 "the output is another" "${rounding}\n```text\nposition violation  9.00e-10 m or rad, largest\n```\n")
set(times "```sh\n./run compare simple_pendulum --t-end 0.1 --formulations r-omega,r-p | grep '^r-p '\n```\n")
expect(1 "the output is another" "${times}\n```text times\nr-p 9951 0 99 99 0.001 0 -\n```\n")
# commands in sentences and tables
expect(0 "^$" "Type `./run check heavy_top`, and `./run solve SCENE --json`.\n")
expect(1 "failed: ./run check heavy_tpo" "| task | `./run check heavy_tpo` |\n")
expect(1 "failed: ./run solve heavy_top --scalar 60" "Type `./run solve heavy_top\n--scalar 60`.\n")
expect(1 "run has no command papr|there is no command" "Type `./run papr`.\n")
# blocks that would not be checked
expect(1 "no page has blocks of the kind txt" "```txt\na\n```\n")
expect(1 "the block behind commands is their output" "${command}\n```\n${output}\n```\n")
expect(1 "a json block is a file" "```json\n{}\n```\n")
expect(1 "a block begins with" "~~~sh\n./run list\n~~~\n")
expect(1 "there is no target trivium::trivum" "```cmake\ntarget_link_libraries(a PRIVATE trivium::trivum)\n```\n")
