package robotran.robolang.syntax

/**
 * How much there can be of anything in a program, so that no source can overflow the stack, the memory or the clock.
 */
object RobolangLimits {
    /** The longest source, in UTF-16 characters: several times the longest program a class could write. */
    const val SOURCE_CHARACTERS = 1_000_000

    /** How many blocks may be inside each other; the phases behind the parser walk the tree by recursion. */
    const val NESTED_BLOCKS = 100

    /** How many brackets, operators and calls may be inside each other, for the same reason. */
    const val NESTED_EXPRESSIONS = 100

    /** The brick's inputs, as they are printed on it. */
    val SENSOR_PORTS: IntRange = 1..3

    /** The power of a motor. */
    val POWERS: IntRange = 0..7

    /** How many characters the LCD shows. */
    const val TEXT_CHARACTERS = 5

    /** How many elements an array can have on the brick: leJOS keeps its length in 9 bits. */
    const val LIST_ELEMENTS = 511

    /**
     * How many variables and parameters a method, or static fields a class, can have on the brick: their numbers are
     * bytes.
     */
    const val VARIABLES = 255

    /** How many parameters a routine can have on the brick: the linker of leJOS takes no more. */
    const val PARAMETERS = 16

    /**
     * How many large or decimal numbers and texts a class can have on the brick: its constants are numbered in a byte.
     */
    const val CONSTANTS = 255

    /** How many routines a program can have: the brick numbers the methods of a class in a byte. */
    const val ROUTINES = 255

    /** How long one move or wait may last, in milliseconds: one day, far below what 32 bits hold. */
    const val LONGEST_COMMAND_MILLISECONDS = 86_400_000

    /** Digits of a decimal number that count; as many as surely fit a double, where a 32-bit float keeps seven. */
    const val DECIMAL_DIGITS = 15

    /** Longer words get no suggestion, so that comparing them costs next to nothing. */
    const val SUGGESTION_CHARACTERS = 24

    /** A message quotes at most so many characters of the source. */
    const val QUOTED_CHARACTERS = 40
}
