package robotran.tinyvm.config

/**
 * The memory that leJOS leaves for a program. The image goes directly behind the firmware, and objects go behind the
 * image. Source: leJOS `main.c`, and the first segment of the released `lejos.srec` files.
 *
 * @property imageAddress where the image begins in the brick's memory.
 */
enum class BrickRoom(val imageAddress: Int) {
    V2_1(0xB576),
    V3_0(0xB8F2),
    ;

    /** Bytes for image and objects together. */
    val bytes: Int get() = HEAP_END - imageAddress

    /**
     * Bytes for objects behind an image of [imageBytes]: they begin at an even address, behind two bytes with the address
     * of their end.
     */
    internal fun objectBytes(imageBytes: Int): Int = bytes - (imageBytes + 1) / 2 * 2 - 2

    /** Max size of an image: the byte behind it must be below 0xEECE for the firmware, and [START_BYTES] must be left. */
    val maxImageBytes: Int get() = minOf(LOADER_END - 1 - imageAddress, bytes - START_BYTES)

    companion object {
        /** The byte behind the heap. */
        private const val HEAP_END = 0xEF32

        /** The firmware gives up a download that reaches this address. */
        private const val LOADER_END = 0xEECE

        /**
         * Bytes of objects that the firmware creates before `main` begins: the thread of `main` (36), its stack (88) and
         * twelve exceptions of 8 bytes, and what is left for the first objects of the program itself.
         */
        const val START_BYTES = 256

        /** With fewer bytes left for objects, a program gets a warning. A text of 20 characters takes about 60. */
        const val FEW_BYTES = 1024

        fun of(version: LejosVersion): BrickRoom = when (version) {
            LejosVersion.V2_1 -> V2_1
            LejosVersion.V3_0 -> V3_0
        }
    }
}
