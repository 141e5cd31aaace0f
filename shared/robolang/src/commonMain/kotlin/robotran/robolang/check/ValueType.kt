package robotran.robolang.check

/** The type of an expression. [NOTHING] is a procedure call, or unknown because of an error. */
internal enum class ValueType {
    /** A 32-bit whole number, Java's `int`. */
    WHOLE,

    /** A 32-bit decimal number, Java's `float`. */
    DECIMAL,

    /** True or false. */
    TRUTH,

    /** One of the colours of a colour sensor. */
    COLOUR,

    LIST_OF_WHOLE,

    LIST_OF_DECIMAL,

    NOTHING,
    ;

    val isNumber: Boolean get() = this == WHOLE || this == DECIMAL

    val isList: Boolean get() = this == LIST_OF_WHOLE || this == LIST_OF_DECIMAL

    /** The type of one element of a list. */
    val element: ValueType
        get() = when (this) {
            LIST_OF_WHOLE -> WHOLE
            LIST_OF_DECIMAL -> DECIMAL
            WHOLE, DECIMAL, TRUTH, COLOUR, NOTHING -> NOTHING
        }
}
