package robotran.nqc.tree

/** One item of `asm { }`. */
internal sealed class AssemblyField {
    abstract val value: Expression

    /** A byte. */
    class Byte(override val value: Expression) : AssemblyField()

    /** `$value : restriction`: the bytes that say where the value is found. */
    class Operand(override val value: Expression, private val restriction: Int) : AssemblyField() {
        /** The sources that the command allows, bit n for source n; 0 for all. */
        val sources: Int get() = restriction and SOURCES

        /** Whether the argument has one byte, not two. */
        val isSmall: Boolean get() = restriction and SMALL != 0

        /** Whether the source itself is left out. */
        val hasNoType: Boolean get() = restriction and NO_TYPE != 0

        /** Whether the variables of a task are allowed. */
        val allowsLocals: Boolean get() = restriction and NO_LOCALS == 0
    }

    companion object {
        const val SOURCES = 0xFFFFFF
        const val SMALL = 0x1000000
        const val NO_TYPE = 0x2000000
        const val NO_LOCALS = 0x4000000
    }
}
