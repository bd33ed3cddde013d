# Runs `generator` into the folder `scratch` and fails where a file there is not, byte for byte, the one of that name
# in `data`, or `data` holds a file that the generator does not make.

file(REMOVE_RECURSE "${scratch}")
file(MAKE_DIRECTORY "${scratch}")
execute_process(COMMAND "${generator}" "${scratch}" COMMAND_ERROR_IS_FATAL ANY)

file(GLOB made RELATIVE "${scratch}" "${scratch}/*")
file(GLOB kept RELATIVE "${data}" LIST_DIRECTORIES false "${data}/*")
list(REMOVE_ITEM kept README.md)
if(NOT made STREQUAL kept)
  message(SEND_ERROR "data/ holds ${kept}\nthe generator makes ${made}")
endif()
foreach(name IN LISTS made)
  if(NOT EXISTS "${data}/${name}")
    continue()
  endif()
  file(SHA256 "${scratch}/${name}" new)
  file(SHA256 "${data}/${name}" old)
  if(NOT new STREQUAL old)
    message(SEND_ERROR "${name} is not what the generator makes: build the target make_data and look at the change")
  endif()
endforeach()
