package robotran.legofirmware.instructions

/** An operand of an [Instruction]; [OperandKind] says which opcode has which. */
sealed interface Operand {
    /**
     * A value that is read, or the place that `set` writes to.
     *
     * @property source see [ValueSource]; 0..255, and 0..63 in a test.
     * @property argument -32768..32767, or 0..255 where the operand has one byte for it.
     */
    data class Value(val source: Int, val argument: Int) : Operand {
        constructor(source: ValueSource, argument: Int) : this(source.code, argument)
    }

    /** A number of one byte or two, without a sign. */
    data class Number(val value: Int) : Operand

    /**
     * True if [left] [relation] [right].
     *
     * @property right its argument is 0..255.
     */
    data class Test(val relation: Relation, val left: Value, val right: Value) : Operand

    /** Where the instruction may continue, in bytes from the beginning of the task or subroutine. */
    data class Address(val address: Int) : Operand
}

/** @property symbol as in a listing. */
enum class Relation(val code: Int, val symbol: String) {
    AT_MOST(0, "<="),
    AT_LEAST(1, ">="),
    NOT_EQUAL(2, "!="),
    EQUAL(3, "=="),
    ;

    companion object {
        fun of(code: Int): Relation = entries.first { it.code == code }
    }
}
