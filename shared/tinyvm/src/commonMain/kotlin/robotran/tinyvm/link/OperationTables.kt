package robotran.tinyvm.link

/** The operations for ranges of consecutive bytecodes. */
internal object OperationTables {
    /** For int, long, float, double, objects, bytes, characters and shorts. */
    private val ARRAY_STORES = listOf(
        Operation.SET_ELEMENT,
        Operation.SET_WIDE,
        Operation.SET_ELEMENT,
        Operation.SET_WIDE,
        Operation.SET_REFERENCE,
        Operation.SET_BYTE,
        Operation.SET_CHARACTER,
        Operation.SET_SHORT,
    )

    /** In opcode order: equal, not equal, less, not less, greater, not greater. */
    private val IF_ZERO = listOf(
        Operation.IF_ZERO,
        Operation.IF_NOT_ZERO,
        Operation.IF_NEGATIVE,
        Operation.IF_NOT_NEGATIVE,
        Operation.IF_POSITIVE,
        Operation.IF_NOT_POSITIVE,
    )

    private val IF_EQUAL = listOf(
        Operation.IF_EQUAL,
        Operation.IF_NOT_EQUAL,
        Operation.IF_LESS,
        Operation.IF_NOT_LESS,
        Operation.IF_GREATER,
        Operation.IF_NOT_GREATER,
    )

    fun load(opcode: Int, isExact: Boolean): Int = when {
        (opcode - Opcode.ILOAD) % 2 == 0 -> Operation.LOAD
        isExact -> Operation.LOAD_LONG
        else -> Operation.LOAD_WIDE
    }

    fun store(opcode: Int, isExact: Boolean): Int = when {
        (opcode - Opcode.ISTORE) % 2 == 0 -> Operation.STORE
        isExact -> Operation.STORE_LONG
        else -> Operation.STORE_WIDE
    }

    fun arrayLoad(opcode: Int, isExact: Boolean): Int = when (opcode - Opcode.IALOAD) {
        1, 3 -> if (isExact) Operation.ELEMENT_LONG else Operation.ELEMENT_WIDE
        else -> Operation.ELEMENT
    }

    fun arrayStore(opcode: Int, isExact: Boolean): Int {
        val operation = ARRAY_STORES[opcode - Opcode.IASTORE]
        return if (isExact && operation == Operation.SET_WIDE) Operation.SET_ELEMENT_LONG else operation
    }

    fun branch(opcode: Int): Int = when (opcode) {
        Opcode.IFNULL -> Operation.IF_ZERO
        Opcode.IFNONNULL -> Operation.IF_NOT_ZERO
        Opcode.IF_ACMPEQ -> Operation.IF_EQUAL
        Opcode.IF_ACMPNE -> Operation.IF_NOT_EQUAL
        Opcode.GOTO -> Operation.JUMP
        Opcode.JSR -> Operation.SUBROUTINE
        in Opcode.IFEQ..Opcode.IFLE -> IF_ZERO[opcode - Opcode.IFEQ]
        else -> IF_EQUAL[opcode - Opcode.IF_ICMPEQ]
    }
}
