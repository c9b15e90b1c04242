# Writes OUTPUT, a C++ file with the parts of the report's page as raw strings: FOLDER's files, and the plotting library CHART_JS.
set(members html page.html style page.css script page.js chartLicense chart_js_license.txt)
set(code "#include \"core/report/html_page.h\"\n\nnamespace mirrorball {\n\nPageParts pageParts()\n{\n    return {\n")
while(members)
  list(POP_FRONT members member file)
  file(READ "${FOLDER}/${file}" text)
  string(APPEND code "        .${member} = R\"page(${text})page\",\n")
endwhile()
file(READ "${CHART_JS}" text)
string(REGEX REPLACE "\n//# sourceMappingURL=[^\n]*" "" text "${text}") # a map that is not here would be asked for
string(APPEND code "        .chartLibrary = R\"page(${text})page\",\n    };\n}\n\n} // namespace mirrorball\n")
file(WRITE "${OUTPUT}" "${code}")
