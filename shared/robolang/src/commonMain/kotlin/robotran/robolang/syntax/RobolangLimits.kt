package robotran.robolang.syntax

/** The limits of a program, so that no source can exhaust the stack, the memory or the time. */
object RobolangLimits {
    /** The max source length in UTF-16 characters: several times the longest program that a class could write. */
    const val SOURCE_CHARACTERS = 1_000_000

    /** The max nesting of blocks; later phases walk the tree recursively. */
    const val NESTED_BLOCKS = 100

    /** The max nesting of brackets, operators and calls, for the same reason. */
    const val NESTED_EXPRESSIONS = 100

    /** The power of a motor. */
    val POWERS: IntRange = 0..7

    /** The max array length on the brick: leJOS stores it in 9 bits. */
    const val LIST_ELEMENTS = 511

    /**
     * The max number of variables and parameters of a method, or static fields of a class, on the brick: their indices
     * are bytes.
     */
    const val VARIABLES = 255

    /** The max number of parameters of a routine on the brick; a limit of the leJOS linker. */
    const val PARAMETERS = 16

    /**
     * The max number of large numbers, decimal numbers and texts of a class on the brick: constant indices are bytes.
     */
    const val CONSTANTS = 255

    /** The max number of routines: the brick's method indices are bytes. */
    const val ROUTINES = 255

    /** The max duration of one move or wait in milliseconds: one day, far below 32 bits. */
    const val LONGEST_COMMAND_MILLISECONDS = 86_400_000

    /** The significant digits of a decimal number; as many as a double always holds. A 32-bit float holds seven. */
    const val DECIMAL_DIGITS = 15

    /** Longer words get no suggestion, which bounds the cost of comparing them. */
    const val SUGGESTION_CHARACTERS = 24

    /** The max length of a quotation of the source in a message. */
    const val QUOTED_CHARACTERS = 40
}
