# cmake -DREADME=... -DEXAMPLE=... -P: fails unless the README shows the example (without its header).
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(FIND "${example}" "#include" code_begin)
string(SUBSTRING "${example}" ${code_begin} -1 code)
string(FIND "${readme}" "```cpp\n${code}```" position)
if(position EQUAL -1)
  message(FATAL_ERROR "${README} does not show the code of ${EXAMPLE}: copy it there.")
endif()
