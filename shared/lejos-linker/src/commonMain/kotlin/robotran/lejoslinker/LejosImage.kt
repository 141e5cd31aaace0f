package robotran.lejoslinker

import robotran.lejoslinker.image.ImageContents
import robotran.tinyvm.config.BrickLayout
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion

/**
 * A program as leJOS's firmware runs it.
 *
 * @property bytes the whole image; it begins with CA F6.
 * @property contents what the bytes hold, in words.
 */
class LejosImage(val bytes: ByteArray, val contents: ImageContents) {
    /** The internal names of the classes that can be started, in the order of the Prgm button. */
    val entryClasses: List<String> get() = contents.entryClasses.map { contents.classes[it].name }

    /** For a run of the same program on the virtual machine. */
    val layout: BrickLayout
        get() = BrickLayout(
            bytes.size,
            contents.classes.withIndex().associate { it.value.name to it.index },
            contents.signatures.withIndex().associate { it.value to it.index },
        )

    /** Bytes of a brick's memory that are left for objects, arrays and the stacks of threads. */
    fun bytesForObjects(version: LejosVersion): Int = BrickRoom.of(version).bytes - bytes.size
}
