package robotran.tinyvm.config

/** A difference between the brick and the Java language. */
enum class Quirk {
    /** A division or remainder by a number that does not fit 16 bits. */
    DIVISOR_OF_16_BITS,

    /** An array index that does not fit 16 bits. */
    INDEX_OF_16_BITS,

    /** A cast to char of a number above 32767; the result is negative. */
    SIGNED_CHARACTER,

    /** A type test or cast to an interface; it always succeeds. */
    UNCHECKED_INTERFACE,

    /** An array of more than 511 elements. */
    LONG_ARRAY,

    /** More memory in use than a brick has. */
    HEAP_FULL,

    /** A comparison with NaN; the two values count as equal. */
    NOT_A_NUMBER,

    /** A call of `Thread.join`, which leJOS never implemented; it returns at once. */
    JOIN_DOES_NOTHING,

    /** A call of a private or static `synchronized` method, or of one with `super`; it locks nothing. */
    UNLOCKED_METHOD,

    /** An array of three or more dimensions that is created at once; there is no memory for it. */
    DEEP_ARRAY,

    /** Calls inside each other that need more stack than a brick has. */
    DEEP_CALLS,

    /** A static initializer that runs although that of a superclass has not run yet. */
    LATE_INITIALIZER,

    /** An exception in the statement directly before a `try`; its `catch` or `finally` is taken. */
    EARLY_HANDLER,

    /** A sleep or a wait of less than 0 milliseconds; it ends at once. */
    NEGATIVE_TIME,

    /** A negative `long` that becomes a decimal number; the result is positive. */
    NEGATIVE_LONG,

    /** An object that is stored in an array of another class; nothing checks it. */
    UNCHECKED_ELEMENT,

    /** A `catch` after a failed cast or a failed new array; its variable does not get the exception. */
    LOST_EXCEPTION,
}
