package robotran.tinyvm.link

/**
 * What the verifier knows of a word among locals and operands, as a number: one of these kinds, [reference] of a type
 * of objects, or [returnAddress] of a subroutine. Only words of the same kind are ever exchanged, so a number never
 * passes for a reference.
 */
internal object VerificationType {
    /** Nothing that may be read. */
    const val UNUSABLE = 0
    const val WHOLE = 1
    const val DECIMAL = 2
    const val LONG = 3
    const val DOUBLE = 4

    /** The second word of a [LONG] or [DOUBLE]. */
    const val SECOND_WORD = 5
    const val NULL = 6
    private const val FIRST_REFERENCE = 8

    fun reference(type: HeapType): Int = FIRST_REFERENCE + type.id

    fun isReference(value: Int): Boolean = value >= NULL

    /** The id of the type of objects that [value] refers to; only for references that are not null. */
    fun typeId(value: Int): Int = value - FIRST_REFERENCE

    /** @param context the number of the subroutine's context, from 1. */
    fun returnAddress(context: Int): Int = -context

    fun isReturnAddress(value: Int): Boolean = value < 0

    fun isWide(value: Int): Boolean = value == LONG || value == DOUBLE

    /** The kind that a letter of a descriptor or of [SimpleInstruction] stands for; numbers only. */
    fun ofLetter(letter: Char): Int = when (letter) {
        'F' -> DECIMAL
        'J' -> LONG
        'D' -> DOUBLE
        else -> WHOLE
    }
}
