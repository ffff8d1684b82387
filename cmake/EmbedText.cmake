# cmake -DINPUT=file -DOUTPUT=header -DNAME=constant -P: the text as a C++ constant.
file(READ "${INPUT}" text)
file(WRITE "${OUTPUT}" "constexpr const char* ${NAME} = R\"text(${text})text\";\n")
