package robotran.tinyvm.link

/**
 * An operand of the stack code while it is compiled to [RegisterCode].
 *
 * @property register its place on the operand stack.
 * @property value the local if it is [LOCAL], the number if it is [CONSTANT].
 */
internal class Operand(val kind: Int, val register: Int, val value: Int = 0) {
    val isConstant: Boolean get() = kind == CONSTANT

    fun isConstantIn(range: IntRange): Boolean = isConstant && value in range

    companion object {
        /** The operand is on the stack. */
        const val ON_STACK = 0

        /** It is still in a local. */
        const val LOCAL = 1

        /** It is known. */
        const val CONSTANT = 2
    }
}
