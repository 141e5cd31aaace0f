package robotran.world.file

import robotran.json.JsonReading
import robotran.json.readJson
import robotran.json.writeJson
import robotran.language.Language
import robotran.world.World

/**
 * Reads a world file; `docs/worlds.md` describes the format. Returns quickly for any text: it reads the file exactly or
 * rejects it. Unknown fields are preserved in the world's [UnknownFields].
 *
 * @param language the language of error messages.
 */
fun readWorld(text: String, language: Language): WorldFileResult = resultOf(readJson(text, language, ::worldIn))

/** The same for the bytes of a file, in any encoding that [robotran.language.decodeText] knows. */
fun readWorld(bytes: ByteArray, language: Language): WorldFileResult = resultOf(readJson(bytes, language, ::worldIn))

/**
 * [world] as a file of the newest version, readable and easy to merge. Omits default values and keeps unknown fields.
 * [readWorld] restores the same world if its numbers have at most fifteen digits, as those of a world from a file have.
 */
fun writeWorld(world: World): String = writeJson(elementOf(world), MULTILINE_LISTS)

private fun resultOf(reading: JsonReading<World>): WorldFileResult = when (reading) {
    is JsonReading.Success -> WorldFileResult.Success(reading.value, reading.warnings)
    is JsonReading.Failure -> WorldFileResult.Failure(reading.message, reading.line, reading.path)
}
