# How every target of the project is compiled.

add_library(holdfast_warnings INTERFACE)
target_compile_options(holdfast_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  -Wold-style-cast -Wcast-qual -Wformat=2 -Wimplicit-fallthrough -Wundef)
# g++ 12 sees overlapping copies in `"literal" + std::string` where there are none (GCC bug 105651).
target_compile_options(holdfast_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# A target of this project: C++20, hidden symbols, strict warnings.
function(holdfast_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:holdfast_warnings>)
endfunction()

# The layer `name`: a static library made of every source below `root`, its headers public, save those named
# *_internal.h. Sources are found, not listed: the folder is the list. Every header needs nothing before it: its own
# source includes it first (tests/layering/check_own_headers.sh), and those without a source are compiled alone.
function(holdfast_add_layer name root)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${root}/*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${root}/*.h")
  list(FILTER headers EXCLUDE REGEX "_internal\\.h$")
  add_library(holdfast_${name} STATIC ${sources})
  add_library(holdfast::${name} ALIAS holdfast_${name})
  set(headers_alone ${headers})
  foreach(source IN LISTS sources)
    string(REGEX REPLACE "\\.cpp$" ".h" own_header "${source}")
    list(REMOVE_ITEM headers_alone "${own_header}")
  endforeach()
  list(REMOVE_ITEM headers ${headers_alone})
  target_sources(holdfast_${name} PUBLIC
    FILE_SET HEADERS BASE_DIRS "${root}" FILES ${headers}
    FILE_SET headers_alone TYPE HEADERS BASE_DIRS "${root}" FILES ${headers_alone})
  set_target_properties(holdfast_${name} PROPERTIES EXPORT_NAME ${name}
    VERIFY_INTERFACE_HEADER_SETS ON INTERFACE_HEADER_SETS_TO_VERIFY headers_alone)
  holdfast_configure(holdfast_${name})
endfunction()
