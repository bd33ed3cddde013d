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

# The layer `name`: a static library made of every source below `root`, its headers public and each compiled alone,
# save those named *_internal.h. Sources are found, not listed: the folder is the list.
function(holdfast_add_layer name root)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${root}/*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${root}/*.h")
  list(FILTER headers EXCLUDE REGEX "_internal\\.h$")
  add_library(holdfast_${name} STATIC ${sources})
  add_library(holdfast::${name} ALIAS holdfast_${name})
  target_sources(holdfast_${name} PUBLIC FILE_SET HEADERS BASE_DIRS "${root}" FILES ${headers})
  set_target_properties(holdfast_${name} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  holdfast_configure(holdfast_${name})
endfunction()
