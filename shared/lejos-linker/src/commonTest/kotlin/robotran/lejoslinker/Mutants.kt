package robotran.lejoslinker

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
        linkLejosImage(own, Vectors.library + changed, listOf(program))
    } else {
        linkLejosImage(own + changed, Vectors.library, listOf(program))
    }
}
