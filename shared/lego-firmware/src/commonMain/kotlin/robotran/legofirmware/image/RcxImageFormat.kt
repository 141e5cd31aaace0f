package robotran.legofirmware.image

/** The numbers of the file format RCXI. All numbers in a file have their low byte first. */
internal object RcxImageFormat {
    const val SIGNATURE = "RCXI"

    /** Version 1.02. Readers accept all that are not greater. */
    const val VERSION = 0x0102
    const val HEADER_BYTES = 12
    const val CHUNK_HEADER_BYTES = 4
    const val SYMBOL_HEADER_BYTES = 4

    /** Zero bytes fill the code of a chunk up to a multiple of this. */
    const val ALIGNMENT = 4

    /** The bytes that code of [length] bytes takes in the file. */
    fun padded(length: Int): Int = (length + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT
}
