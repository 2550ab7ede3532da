# Writes the C++ source of partwise_embed (EmbedFiles.cmake).
# usage: cmake -DOUTPUT=x.cpp -DHEADER=io/x.h -DFUNCTION=x "-DFILES=a.json;b.json" -P write-embedded-files.cmake
set(entries "")
foreach(path IN LISTS FILES)
  get_filename_component(name ${path} NAME)
  file(READ ${path} text)
  if(NOT text STREQUAL "")
    string(APPEND entries "    {\"${name}\", R\"embedded_file(${text})embedded_file\"},\n")
  endif()
endforeach()
get_filename_component(namespace ${HEADER} DIRECTORY)
file(WRITE ${OUTPUT}.new "#include \"${HEADER}\"

#ifdef __clang__
#pragma clang diagnostic ignored \"-Woverlength-strings\"
#endif

namespace partwise::${namespace} {

const std::map<std::string, const char*>& ${FUNCTION}() {
  static const std::map<std::string, const char*> files{
${entries}  };
  return files;
}

}  // namespace partwise::${namespace}
")
file(RENAME ${OUTPUT}.new ${OUTPUT})
