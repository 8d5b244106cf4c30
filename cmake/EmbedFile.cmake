# cmake -DINPUT=FILE -DOUTPUT=FILE.inc -P EmbedFile.cmake: the bytes of a file as a string literal of
# C++, for any compiler and any kind of program file.
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
# Lines of 64 bytes, four characters each.
string(REPEAT "." 256 line)
string(REGEX REPLACE "(${line})" "\\1\"\n\"" bytes "${bytes}")
file(WRITE "${OUTPUT}" "\"${bytes}\"\n")
