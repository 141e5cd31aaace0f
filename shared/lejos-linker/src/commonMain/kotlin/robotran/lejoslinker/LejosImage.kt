package robotran.lejoslinker

import robotran.lejoslinker.config.BrickRoom
import robotran.lejoslinker.image.ImageContents
import robotran.tinyvm.config.LejosVersion

/**
 * A program as leJOS's firmware runs it.
 *
 * @property bytes the whole image; it begins with CA F6.
 * @property contents what the bytes hold, in words.
 */
class LejosImage(val bytes: ByteArray, val contents: ImageContents) {
    /** Bytes of a brick's memory that are left for objects, arrays and the stacks of threads. */
    fun bytesForObjects(version: LejosVersion): Int = BrickRoom.of(version).bytes - bytes.size
}
