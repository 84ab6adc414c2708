# cmake -D SOURCE=... -D COPY=... -P PublicHeader.cmake: copies a header of a room for users of a library. An include of
# another header of ours gets the folder limen/.
file(READ ${SOURCE} text)
string(REGEX REPLACE "#include \"((core|geometry|visibility|dat|engine)/)" "#include \"limen/\\1" text "${text}")
file(WRITE ${COPY} "${text}")
