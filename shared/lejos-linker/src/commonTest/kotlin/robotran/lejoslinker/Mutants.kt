package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.messages.ImageMessages
import kotlin.random.Random

/** Links [program] of the vectors with one to three bytes of one of its class files changed, or of the library's. */
internal fun linkMutant(program: String, random: Random): ImageResult {
    val own = Vectors.programs.filterKeys { it == program || it.startsWith("$program$") }
    val ofLibrary = random.nextInt(4) == 0
    val name = (if (ofLibrary) Vectors.library else own).keys.random(random)
    val bytes = (if (ofLibrary) Vectors.library else own).getValue(name).copyOf()
    repeat(1 + random.nextInt(3)) {
        bytes[random.nextInt(8, bytes.size)] =
            if (random.nextBoolean()) random.nextInt(12).toByte() else random.nextInt().toByte()
    }
    val changed = mapOf(name to bytes)
    return if (ofLibrary) {
        linkBoth(own, Vectors.library + changed, program)
    } else {
        linkBoth(own + changed, Vectors.library, program)
    }
}

/** The whole image; the trimmed one only must not fail. */
private fun linkBoth(program: Map<String, ByteArray>, library: Map<String, ByteArray>, main: String): ImageResult {
    linkLejosImage(
        program,
        library,
        listOf(main),
        ImageOptions(isTrimmed = true),
        messages = ImageMessages.of(Language.ENGLISH),
    )
    return linkLejosImage(program, library, listOf(main), messages = ImageMessages.of(Language.ENGLISH))
}
