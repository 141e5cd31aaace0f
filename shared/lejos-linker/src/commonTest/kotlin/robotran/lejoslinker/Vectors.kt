package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.config.ByteOrder
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.messages.ImageMessages
import kotlin.io.encoding.Base64

/** What leJOS's own linker made, and what it made it of. */
internal object Vectors {
    val library: Map<String, ByteArray> by lazy { read("library") }
    val programs: Map<String, ByteArray> by lazy { read("programs") }
    val refused: Map<String, ByteArray> by lazy { read("refused") }
    val images: Map<String, ByteArray> by lazy { read("images-be") }
    val imagesForEmulator: Map<String, ByteArray> by lazy { read("images-le") }

    private fun read(file: String): Map<String, ByteArray> =
        vectorFiles.getValue("$file.txt").lines().filter { it.isNotEmpty() }.associate { line ->
            line.substringBefore(' ') to Base64.decode(line.substringAfter(' '))
        }
}

/** The image of the vectors' program [name], such as `Square`. */
internal fun linkVector(
    name: String,
    byteOrder: ByteOrder = ByteOrder.BIG_ENDIAN,
    programs: Map<String, ByteArray> = Vectors.programs,
): ImageResult {
    val entryClasses = name.substringAfter('.').split('-')
    val keepsAll = name.startsWith("all-options.")
    return linkLejosImage(
        programs,
        Vectors.library,
        entryClasses,
        ImageOptions(byteOrder = byteOrder, keepsAllMethods = keepsAll),
        messages = ImageMessages.of(Language.ENGLISH),
    )
}
