package robotran.projects

import kotlinx.serialization.json.JsonObject
import robotran.json.JsonCursor
import robotran.json.jsonObject
import robotran.nxt.storage.FlashMemory
import robotran.nxt.storage.NxtFile
import robotran.projects.messages.reason
import kotlin.io.encoding.Base64

/** The files of a robot's flash memory as a project keeps them: name, and content in Base64. */
internal fun nxtFilesIn(cursor: JsonCursor): List<NxtFile> {
    val files = cursor.items(0..ProjectLimits.MAXIMUM_FLASH_FILES).map { file ->
        (file.names - FLASH_FIELDS).firstOrNull()?.let { field -> file.refuse(reason { mustNotHave(field) }) }
        // A program may give a file any name, and a project that was saved must open again.
        val name = file.member("name").longText(NxtFile.LONGEST_NAME)
        val attributes = file.optional(ATTRIBUTES)?.wholeNumber(0..MOST_ATTRIBUTES) ?: 0
        NxtFile(name, file.optional(CONTENT)?.let(::bytesIn) ?: ByteArray(0), attributes)
    }
    if (!FlashMemory.holds(files)) cursor.refuse(reason { mustFitIntoFlash() })
    return files
}

internal fun elementOf(file: NxtFile): JsonObject = jsonObject {
    text("name", file.name)
    number(ATTRIBUTES, file.attributes, default = 0)
    text(CONTENT, Base64.encode(file.content()).takeIf { file.size > 0 })
}

private fun bytesIn(cursor: JsonCursor): ByteArray = try {
    Base64.decode(cursor.text(ProjectLimits.MAXIMUM_FLASH_CHARACTERS))
} catch (_: IllegalArgumentException) {
    cursor.refuse(reason { mustBeBytes() })
}

private const val CONTENT = "content"
private const val ATTRIBUTES = "attributes"
private const val MOST_ATTRIBUTES = 255
private val FLASH_FIELDS = setOf("name", CONTENT, ATTRIBUTES)
