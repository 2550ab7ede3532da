# Writes a C++ source that holds the text of every schema, so that the tools need no files when they run.
# Called as a script: cmake -DOUTPUT=... -DSCHEMAS=a.schema.json;b.schema.json -P EmbedSchemas.cmake
set(entries "")
foreach(path IN LISTS SCHEMAS)
  get_filename_component(name ${path} NAME)
  string(REPLACE ".schema.json" "" name ${name})
  file(READ ${path} text)
  string(APPEND entries "    {\"${name}\", R\"schema(${text})schema\"},\n")
endforeach()
file(WRITE ${OUTPUT}.new "#include \"io/embedded_schemas.h\"

namespace partwise::io {

const std::map<std::string, const char*>& embedded_schemas() {
  static const std::map<std::string, const char*> schemas{
${entries}  };
  return schemas;
}

}  // namespace partwise::io
")
file(RENAME ${OUTPUT}.new ${OUTPUT})
