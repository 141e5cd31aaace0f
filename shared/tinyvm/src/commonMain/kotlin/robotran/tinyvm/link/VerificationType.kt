package robotran.tinyvm.link

/**
 * The verifier's type of a word in locals or operands, as a number: one of these kinds, a [reference] to a heap type,
 * or the [returnAddress] of a subroutine. Words of different kinds never merge into a usable type, so a number is never
 * taken for a reference.
 */
internal object VerificationType {
    /** A word that must not be read. */
    const val UNUSABLE = 0
    const val INT = 1
    const val FLOAT = 2
    const val LONG = 3
    const val DOUBLE = 4

    /** The second word of a [LONG] or [DOUBLE]. */
    const val SECOND_WORD = 5
    const val NULL = 6
    private const val FIRST_REFERENCE = 8

    fun reference(type: HeapType): Int = FIRST_REFERENCE + type.id

    fun isReference(value: Int): Boolean = value >= NULL

    /** The heap type id of [value], which must be a reference other than null. */
    fun typeId(value: Int): Int = value - FIRST_REFERENCE

    /** @param context the index of the subroutine's context, from 1. */
    fun returnAddress(context: Int): Int = -context

    fun isReturnAddress(value: Int): Boolean = value < 0

    fun isWide(value: Int): Boolean = value == LONG || value == DOUBLE

    /** The kind for a letter of a descriptor or of [SimpleInstruction]; numbers only. */
    fun ofLetter(letter: Char): Int = when (letter) {
        'F' -> FLOAT
        'J' -> LONG
        'D' -> DOUBLE
        else -> INT
    }
}
