package robotran.tinyvm.link

/**
 * Operations that do the work of several frequent ones in a row, for speed. They replace only the first operation; all
 * operands, and the other operations, stay where they are. So jumps, handlers and line numbers stay valid, and the
 * interpreter can go back to the plain code at any place.
 */
internal object FusedOperations {
    const val LOAD_LOAD = 106
    const val LOAD_PUSH = 107
    const val LOAD_FIELD = 108
    const val LOAD_LOAD_IF_LESS = 109
    const val LOAD_LOAD_IF_NOT_LESS = 110
    const val LOAD_PUSH_IF_LESS = 111
    const val LOAD_PUSH_IF_NOT_LESS = 112
    const val LOAD_LOAD_ELEMENT = 113
    const val LOAD_FIELD_LOAD_ELEMENT = 114
    const val LOAD_FIELD_LOAD = 115
    const val LOAD_ADD = 116
    const val PUSH_ADD = 117
    const val PUSH_SUBTRACT = 118
    const val PUSH_MULTIPLY = 119
    const val PUSH_AND = 120
    const val PUSH_SHIFT_LEFT = 121
    const val PUSH_SHIFT_RIGHT = 122
    const val ADD_STORE = 123

    /** Longer sequences first, since the first that matches is used. */
    private val SEQUENCES = listOf(
        LOAD_FIELD_LOAD_ELEMENT to
            listOf(Operation.LOAD, Operation.FIELD, Operation.LOAD, Operation.ELEMENT),
        LOAD_LOAD_IF_LESS to listOf(Operation.LOAD, Operation.LOAD, Operation.IF_LESS),
        LOAD_LOAD_IF_NOT_LESS to listOf(Operation.LOAD, Operation.LOAD, Operation.IF_NOT_LESS),
        LOAD_PUSH_IF_LESS to listOf(Operation.LOAD, Operation.PUSH, Operation.IF_LESS),
        LOAD_PUSH_IF_NOT_LESS to listOf(Operation.LOAD, Operation.PUSH, Operation.IF_NOT_LESS),
        LOAD_LOAD_ELEMENT to listOf(Operation.LOAD, Operation.LOAD, Operation.ELEMENT),
        LOAD_FIELD_LOAD to listOf(Operation.LOAD, Operation.FIELD, Operation.LOAD),
        LOAD_LOAD to listOf(Operation.LOAD, Operation.LOAD),
        LOAD_PUSH to listOf(Operation.LOAD, Operation.PUSH),
        LOAD_FIELD to listOf(Operation.LOAD, Operation.FIELD),
        LOAD_ADD to listOf(Operation.LOAD, Operation.ADD),
        PUSH_ADD to listOf(Operation.PUSH, Operation.ADD),
        PUSH_SUBTRACT to listOf(Operation.PUSH, Operation.SUBTRACT),
        PUSH_MULTIPLY to listOf(Operation.PUSH, Operation.MULTIPLY),
        PUSH_AND to listOf(Operation.PUSH, Operation.AND),
        PUSH_SHIFT_LEFT to listOf(Operation.PUSH, Operation.SHIFT_LEFT),
        PUSH_SHIFT_RIGHT to listOf(Operation.PUSH, Operation.SHIFT_RIGHT),
        ADD_STORE to listOf(Operation.ADD, Operation.STORE),
    )

    private val WITH_TWO_OPERANDS =
        setOf(Operation.INCREMENT, Operation.CALL_VIRTUAL, Operation.CALL_INTERFACE, Operation.NEW_ARRAYS)

    private val WITH_ONE_OPERAND =
        setOf(Operation.STATEMENT, Operation.PUSH, Operation.PUSH_WIDE, Operation.PUSH_TEXT) +
            (Operation.LOAD..Operation.STORE_WIDE) + (Operation.IF_ZERO..Operation.SET_FIELD_WIDE) +
            setOf(Operation.CALL_STATIC, Operation.CALL_EXACTLY, Operation.NEW, Operation.NEW_ARRAY) +
            setOf(Operation.CAST, Operation.IS_INSTANCE)

    /** A copy of [code] with fused operations. */
    fun fuse(code: IntArray): IntArray {
        val fused = code.copyOf()
        var position = 0
        while (position < code.size) {
            SEQUENCES.firstOrNull { (_, sequence) -> begins(code, position, sequence) }
                ?.let { (operation, _) -> fused[position] = operation }
            position += lengthOf(code[position])
        }
        return fused
    }

    private fun begins(code: IntArray, position: Int, sequence: List<Int>): Boolean {
        var at = position
        for (operation in sequence) {
            if (at >= code.size || code[at] != operation) return false
            at += lengthOf(operation)
        }
        return true
    }

    /** The words of an operation with its operands. */
    private fun lengthOf(operation: Int): Int = when (operation) {
        in WITH_TWO_OPERANDS -> 3
        in WITH_ONE_OPERAND -> 2
        else -> 1
    }
}
