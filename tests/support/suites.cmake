# Read by ctest before it runs anything. Makes each suite of a program of GoogleTest a CTest case, FOLDER/SUITE: the start
# of a program with a display takes longer than most tests. What the program lists is kept beside it until it is built anew.
#   holdfast_add_suites(FOLDER PROGRAM LEFT-OUT LAUNCHER TIMEOUT)      LEFT-OUT: a pattern of GoogleTest

function(holdfast_add_suites folder program left_out launcher timeout)
  if(NOT EXISTS "${program}")
    add_test("${folder}/NotBuilt" "${CMAKE_COMMAND}" -E false)
    return()
  endif()
  set(kept "${program}_suites.txt")
  if("${program}" IS_NEWER_THAN "${kept}")
    execute_process(COMMAND ${launcher} "${program}" --gtest_list_tests "--gtest_filter=-${left_out}"
      OUTPUT_FILE "${kept}" ERROR_VARIABLE errors RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
      file(REMOVE "${kept}")
      message(FATAL_ERROR "${program} does not list its tests: ${errors}")
    endif()
  endif()
  file(STRINGS "${kept}" suites REGEX "^[A-Za-z0-9_/]+\\.( |$)")
  foreach(suite IN LISTS suites)
    string(REGEX REPLACE "\\..*" "" suite "${suite}")
    add_test("${folder}/${suite}" ${launcher} "${program}" "--gtest_filter=${suite}.*-${left_out}")
    set_tests_properties("${folder}/${suite}" PROPERTIES TIMEOUT ${timeout})
  endforeach()
endfunction()
