# Prints a report of holdfast-batch for people. In CMake's language because every machine that builds Holdfast has it.
#   cmake -D REPORT=report.json -P summarize_report.cmake

file(READ "${REPORT}" report)

# The value at a path of keys, numbers cut to four decimals, or a dash where the report has none.
function(read_value result)
  string(JSON value ERROR_VARIABLE error GET "${report}" ${ARGN})
  if(error)
    set(value "-")
  endif()
  string(REGEX REPLACE "^(-?[0-9]+\\.[0-9][0-9][0-9][0-9])[0-9]+" "\\1" value "${value}")
  set(${result} "${value}" PARENT_SCOPE)
endfunction()

# Adds a line with the value at a path of keys to `text`.
function(add_value label)
  read_value(value ${ARGN})
  set(text "${text}  ${label} ${value}\n" PARENT_SCOPE)
endfunction()

# Adds a line for each constraint to `text`.
function(add_constraints)
  string(JSON count LENGTH "${report}" constraints)
  set(index 0)
  while(index LESS count)
    foreach(key IN ITEMS name type status residual)
      read_value(${key} constraints ${index} ${key})
    endforeach()
    string(APPEND text "    ${name} (${type}): ${status}, residual ${residual}\n")
    math(EXPR index "${index} + 1")
  endwhile()
  set(text "${text}" PARENT_SCOPE)
endfunction()

set(text "== Report\n")
add_value("vertices         " mesh vertices)
add_value("faces            " mesh faces)
add_value("outcome          " solve status)
add_value("message          " solve message)
add_value("largest residual " solve max_residual)
add_value("  over diagonal  " solve max_residual_relative)
add_value("unknowns         " solve unknowns)
add_value("set-up, s        " solve seconds setup)
add_value("decomposition, s " solve seconds decomposition)
add_value("solution, s      " solve seconds solution)
string(APPEND text "  constraints\n")
add_constraints()
execute_process(COMMAND "${CMAKE_COMMAND}" -E echo_append "${text}")
