package robotran.tinyvm.config

/** The memory that leJOS NXJ leaves for a program on an NXT, whose code stays in flash. */
object NxtMemory {
    /**
     * Bytes for objects and threads. Of 65,536 bytes of memory, the firmware takes its data and stacks; what is left
     * also holds the static fields. An estimate between 45 and 50 thousand.
     */
    const val HEAP_BYTES = 49_152

    /** A program with more than this part of the memory in use after a collection gets a remark, in hundredths. */
    const val NEARLY_FULL_PERCENT = 90

    /** Bytes before the fields of an object or the elements of a short array. */
    const val HEADER_BYTES = 4

    /** Bytes before the elements of an array that is longer than [SHORT_ARRAY_ELEMENTS]. */
    const val LONG_ARRAY_HEADER_BYTES = 8

    /** The most elements of an array whose length fits its header. */
    const val SHORT_ARRAY_ELEMENTS = 60

    /** The bytes of an array of [length] elements that take [elementBytes] each. */
    fun arrayBytes(length: Int, elementBytes: Int): Int =
        (if (length > SHORT_ARRAY_ELEMENTS) LONG_ARRAY_HEADER_BYTES else HEADER_BYTES) + length * elementBytes
}
