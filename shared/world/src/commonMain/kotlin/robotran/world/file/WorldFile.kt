package robotran.world.file

import robotran.json.JsonReading
import robotran.json.readJson
import robotran.json.writeJson
import robotran.language.Language
import robotran.world.World

/**
 * Reads a world file; `docs/worlds.md` describes the format. Whatever the text is, this ends quickly and with a result:
 * a file is either read as it is meant or refused. Fields that this version does not know are kept in the world's
 * [UnknownFields].
 *
 * @param language what a refusal is told in.
 */
fun readWorld(text: String, language: Language = Language.ENGLISH): WorldFileResult =
    resultOf(readJson(text, language, ::worldIn))

/** The same for a file as it lies on a disk: in UTF-8, with or without a byte order mark. */
fun readWorld(bytes: ByteArray, language: Language = Language.ENGLISH): WorldFileResult =
    resultOf(readJson(bytes, language, ::worldIn))

/**
 * [world] as a file of the newest version, for people to read and to merge: what is as usual is left out, unknown
 * fields are kept. [readWorld] makes the same world of it, if all its numbers have no more than fifteen digits, as
 * those of a world that was read have.
 */
fun writeWorld(world: World): String = writeJson(elementOf(world), TALL_LISTS)

private fun resultOf(reading: JsonReading<World>): WorldFileResult = when (reading) {
    is JsonReading.Read -> WorldFileResult.Loaded(reading.value)
    is JsonReading.Rejected -> WorldFileResult.Rejected(reading.message, reading.line, reading.path)
}
