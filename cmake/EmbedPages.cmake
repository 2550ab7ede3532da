# Writes a C++ source that holds the text of the report's pages, so that the tool needs no files when it runs.
# Called as a script: cmake -DOUTPUT=... -DPAGES=a.html;b.js -P EmbedPages.cmake
# Files that are missing or empty (scripts that could not be bundled) are left out.
set(entries "")
foreach(path IN LISTS PAGES)
  if(NOT EXISTS ${path})
    continue()
  endif()
  get_filename_component(name ${path} NAME)
  file(READ ${path} text)
  if(NOT text STREQUAL "")
    string(APPEND entries "    {\"${name}\", R\"embedded_page(${text})embedded_page\"},\n")
  endif()
endforeach()
file(WRITE ${OUTPUT}.new "#include \"report/embedded_pages.h\"

#ifdef __clang__
#pragma clang diagnostic ignored \"-Woverlength-strings\"
#endif

namespace partwise::report {

const std::map<std::string, const char*>& embedded_pages() {
  static const std::map<std::string, const char*> pages{
${entries}  };
  return pages;
}

}  // namespace partwise::report
")
file(RENAME ${OUTPUT}.new ${OUTPUT})
