package robotran.robolang

/** How much there can be of anything in a program, so that no source can overflow the stack, the memory or the clock. */
object RobolangLimits {
    /** The longest source, in UTF-16 characters: several times the longest program a class could write. */
    const val SOURCE_CHARACTERS = 1_000_000

    /** How many blocks may be inside each other; the phases behind the parser walk the tree by recursion. */
    const val NESTED_BLOCKS = 100

    /** How long one move or wait may last, in milliseconds: one day, far below what 32 bits hold. */
    const val LONGEST_COMMAND_MILLISECONDS = 86_400_000

    /** Digits of a decimal number that count; as many as surely fit a double, where a 32-bit float keeps seven. */
    const val DECIMAL_DIGITS = 15

    /** Longer words get no suggestion, so that comparing them costs next to nothing. */
    const val SUGGESTION_CHARACTERS = 24

    /** A message quotes at most so many characters of the source. */
    const val QUOTED_CHARACTERS = 40
}
