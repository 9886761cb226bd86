# Makes one C++ source of the viewer: style sheet and scripts go into the page, the page into a string literal.
# Usage: cmake -DSOURCE=ref/viewer -DOUTPUT=viewer_page.cpp -P embed.cmake
file(READ "${SOURCE}/page.html" page)
file(READ "${SOURCE}/style.css" style)
set(script "")
foreach(name IN ITEMS vectors shapes slice painter overlay view actions)
  file(READ "${SOURCE}/${name}.js" part)
  string(APPEND script "${part}")
endforeach()
foreach(part IN ITEMS style script)
  string(TOUPPER "${part}" mark)
  string(REPLACE "@${mark}@" "${${part}}" page "${page}")
endforeach()
if(page MATCHES "\\)page\"" OR NOT page MATCHES "@DATA@")
  message(FATAL_ERROR "the page cannot be embedded")
endif()
file(WRITE "${OUTPUT}"
  "#include \"viewer_page.hpp\"\n\nnamespace flatdt::ref {\n\nconst char* const kViewerPage = R\"page(${page})page\";\n\n}  // namespace flatdt::ref\n")
