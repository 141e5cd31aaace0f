package robotran.robolang.python.microbit

import robotran.microbit.model.MicrobitModel

/**
 * How full a board gets with a program.
 *
 * @property statements how many statements of Robolang it has.
 * @property mostStatements how many the memory of the board takes, more or less; null if its files are full before.
 * @property bytes the length of its Python, in UTF-8.
 * @property mostBytes the longest file that there is room for.
 */
data class BoardRoom(val statements: Int, val mostStatements: Int?, val bytes: Int, val mostBytes: Int) {
    /** From 0 for an empty board to 1 for a full one; above 1 it does not fit. */
    val share: Double
        get() = maxOf(bytes.toDouble() / mostBytes, mostStatements?.let { statements.toDouble() / it } ?: 0.0)

    /** Whether the program fits in. */
    val fits: Boolean get() = share <= 1.0

    internal companion object {
        /**
         * From how many statements a V1 may run out of memory, and from how many it will: the parse tree of one file
         * fills its 10 kB. Measured with a build of MicroPython for the PC and twice the heap, so 30 % either way.
         */
        const val MANY_STATEMENTS_V1 = 100
        const val MOST_STATEMENTS_V1 = 250

        /** The longest `main.py` that their file systems have room for beside nothing else. */
        private const val MOST_BYTES_V1 = 28_214
        private const val MOST_BYTES_V2 = 20_150

        /** How many calls fit inside each other: 1,800 and 7,680 bytes of stack, estimates. */
        private const val DEEPEST_CALLS_V1 = 5
        private const val DEEPEST_CALLS_V2 = 30

        fun deepestCallsOn(model: MicrobitModel): Int =
            if (model == MicrobitModel.V1) DEEPEST_CALLS_V1 else DEEPEST_CALLS_V2

        fun of(model: MicrobitModel, statements: Int, python: String): BoardRoom = when (model) {
            MicrobitModel.V1 ->
                BoardRoom(statements, MOST_STATEMENTS_V1, python.encodeToByteArray().size, MOST_BYTES_V1)

            MicrobitModel.V2 -> BoardRoom(statements, null, python.encodeToByteArray().size, MOST_BYTES_V2)
        }
    }
}
