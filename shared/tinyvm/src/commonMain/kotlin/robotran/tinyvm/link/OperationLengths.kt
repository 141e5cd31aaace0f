package robotran.tinyvm.link

private val WITH_TWO_OPERANDS =
    setOf(
        Operation.INCREMENT,
        Operation.CALL_VIRTUAL,
        Operation.CALL_INTERFACE,
        Operation.NEW_ARRAYS,
        Operation.PUSH_LONG,
    )

private val WITH_ONE_OPERAND =
    setOf(Operation.STATEMENT, Operation.PUSH, Operation.PUSH_WIDE, Operation.PUSH_TEXT) +
        (Operation.LOAD..Operation.STORE_WIDE) + (Operation.IF_ZERO..Operation.SET_FIELD_WIDE) +
        setOf(Operation.CALL_STATIC, Operation.CALL_EXACTLY, Operation.NEW, Operation.NEW_ARRAY) +
        setOf(Operation.CAST, Operation.IS_INSTANCE, Operation.SET_FIELD_CHARACTER, Operation.SET_STATIC_CHARACTER) +
        (Operation.LOAD_LONG..Operation.SET_FIELD_LONG) + setOf(Operation.SWITCH, Operation.PUSH_CLASS)

/** The words of an [operation] of [Operation] with its operands. */
internal fun lengthOf(operation: Int): Int = when (operation) {
    in WITH_TWO_OPERANDS -> 3
    in WITH_ONE_OPERAND -> 2
    else -> 1
}
