package robotran.tinyvm.link

/** The operations for ranges of consecutive bytecodes. */
internal object OperationTables {
    /** For int, long, float, double, objects, bytes, characters and shorts. */
    val STORES = listOf(
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
    val IF_ZERO = listOf(
        Operation.IF_ZERO,
        Operation.IF_NOT_ZERO,
        Operation.IF_NEGATIVE,
        Operation.IF_NOT_NEGATIVE,
        Operation.IF_POSITIVE,
        Operation.IF_NOT_POSITIVE,
    )

    val IF_EQUAL = listOf(
        Operation.IF_EQUAL,
        Operation.IF_NOT_EQUAL,
        Operation.IF_LESS,
        Operation.IF_NOT_LESS,
        Operation.IF_GREATER,
        Operation.IF_NOT_GREATER,
    )
}
