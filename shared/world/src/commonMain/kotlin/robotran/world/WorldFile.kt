package robotran.world

import robotran.json.JsonReading
import robotran.json.readJson
import robotran.world.file.worldIn

/**
 * Reads a world file; `docs/worlds.md` describes the format. Whatever the text is, this ends quickly and with a result: a file
 * is either read as it is meant or refused. Fields that this version does not know are kept in the world's [UnknownFields].
 */
fun readWorld(text: String): WorldFileResult = resultOf(readJson(text, ::worldIn))

/** The same for a file as it lies on a disk: in UTF-8, with or without a byte order mark. */
fun readWorld(bytes: ByteArray): WorldFileResult = resultOf(readJson(bytes, ::worldIn))

private fun resultOf(reading: JsonReading<World>): WorldFileResult = when (reading) {
    is JsonReading.Read -> WorldFileResult.Loaded(reading.value)
    is JsonReading.Refused -> WorldFileResult.Refused(reading.message, reading.line, reading.path)
}
