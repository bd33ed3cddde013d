# The options by which every target of the project is compiled.

add_library(holdfast_warnings INTERFACE)
target_compile_options(holdfast_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  -Wold-style-cast -Wcast-qual -Wformat=2 -Wimplicit-fallthrough -Wundef)
# g++ 12 sees overlapping copies in `"literal" + std::string` where there are none (GCC bug 105651).
target_compile_options(holdfast_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# A target of this project: C++20, strict warnings, hidden symbols. Shared libraries show theirs: programs and tests of
# the project use what is not public, too.
function(holdfast_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  if(NOT BUILD_SHARED_LIBS)
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  endif()
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:holdfast_warnings>)
endfunction()

# The layer `name`: a library made of every source below `root`. Sources are found, not listed: the folder is the list.
# PUBLIC are the headers that are installed, below `root`; without them all are, save those named *_internal.h. Every
# header needs nothing before it: its own source includes it first (tests/layering/check_own_headers.sh), and those
# without a source are compiled alone.
function(holdfast_add_layer name root)
  cmake_parse_arguments(PARSE_ARGV 2 layer "" "" PUBLIC)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${root}/*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${root}/*.h")
  set(headers_alone ${headers})
  foreach(source IN LISTS sources)
    string(REGEX REPLACE "\\.cpp$" ".h" own_header "${source}")
    list(REMOVE_ITEM headers_alone "${own_header}")
  endforeach()
  list(FILTER headers EXCLUDE REGEX "_internal\\.h$")
  list(FILTER headers_alone EXCLUDE REGEX "_internal\\.h$")
  if(layer_PUBLIC)
    list(TRANSFORM layer_PUBLIC PREPEND "${root}/" OUTPUT_VARIABLE headers)
  endif()
  add_library(holdfast_${name} ${sources})
  add_library(holdfast::${name} ALIAS holdfast_${name})
  target_sources(holdfast_${name} PUBLIC FILE_SET HEADERS BASE_DIRS "${root}" FILES ${headers})
  set_target_properties(holdfast_${name} PROPERTIES EXPORT_NAME ${name}
    VERSION "${PROJECT_VERSION}" SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
  holdfast_configure(holdfast_${name})

  add_library(holdfast_${name}_headers_alone INTERFACE)
  target_sources(holdfast_${name}_headers_alone INTERFACE FILE_SET HEADERS BASE_DIRS "${root}" FILES ${headers_alone})
  target_link_libraries(holdfast_${name}_headers_alone INTERFACE holdfast_${name})
  set_target_properties(holdfast_${name}_headers_alone PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()
