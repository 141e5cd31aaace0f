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
    /** How full its memory gets, from 0; 0 as well if its files are full before. */
    val memoryShare: Float get() = if (mostStatements == null) 0f else statements.toFloat() / mostStatements

    internal companion object {
        /**
         * From how many statements a V1 may run out of memory, and from how many it will: the parse tree of one file
         * fills its 10 kB. Measured with a build of MicroPython for the PC and twice the heap, so 30 % either way.
         */
        const val MANY_STATEMENTS_V1 = 100
        const val MOST_STATEMENTS_V1 = 250

        /** A file takes chunks of [CHUNK] bytes, [CHUNK_DATA] of them data, and begins with its name and length. */
        private const val CHUNK = 128
        private const val CHUNK_DATA = 126
        private const val FILE_HEAD = 10

        /** How many calls fit inside each other: 1,800 and 7,680 bytes of stack, estimates. */
        private const val DEEPEST_CALLS_V1 = 5
        private const val DEEPEST_CALLS_V2 = 30

        fun deepestCallsOn(model: MicrobitModel): Int =
            if (model == MicrobitModel.V1) DEEPEST_CALLS_V1 else DEEPEST_CALLS_V2

        fun of(model: MicrobitModel, statements: Int, python: String): BoardRoom {
            val mostStatements = MOST_STATEMENTS_V1.takeIf { model == MicrobitModel.V1 }
            // The longest main.py beside nothing else.
            val mostBytes = model.fileBytes / CHUNK * CHUNK_DATA - FILE_HEAD
            return BoardRoom(statements, mostStatements, python.encodeToByteArray().size, mostBytes)
        }
    }
}
