package robotran.tinyvm.config

/** A way in which a brick differs from the Java language. */
enum class Quirk {
    /** A division or remainder by a number that does not fit 16 bits. */
    DIVISOR_OF_16_BITS,

    /** An array index that does not fit 16 bits. */
    INDEX_OF_16_BITS,

    /** A cast to char of a number above 32767, which becomes negative. */
    SIGNED_CHARACTER,

    /** A test or cast to an interface, which always succeeds. */
    UNCHECKED_INTERFACE,

    /** An array of more than 511 elements. */
    LONG_ARRAY,

    /** More memory in use than a brick has. */
    HEAP_FULL,

    /** A comparison with something that is no number, which counts as equal. */
    NOT_A_NUMBER,

    /** A thread that wants to wait for another's end, which leJOS never implemented. */
    JOIN_DOES_NOTHING,
}
