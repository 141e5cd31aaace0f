package robotran.robolang.python.microbit

import robotran.microbit.model.MicrobitModel

/**
 * How full a board gets with a program.
 *
 * @property memoryBytes how much memory the board needs to start it, more or less.
 * @property heapBytes how much memory the board has.
 * @property bytes the length of its Python, in UTF-8.
 * @property mostBytes the longest file that there is room for.
 */
data class BoardRoom(val memoryBytes: Int, val heapBytes: Int, val bytes: Int, val mostBytes: Int) {
    /** How full its memory gets, from 0; above 1 the program may not start. */
    val memoryShare: Float get() = memoryBytes.toFloat() / heapBytes

    internal companion object {
        /** Above so many statements a V1 may run out of memory, and does, however short they are. */
        const val MANY_STATEMENTS_V1 = 100
        const val MOST_STATEMENTS_V1 = 250

        /** The same by [memoryShare], whose figures may be 30 % off either way. */
        const val MUCH_MEMORY = 0.8f
        const val MOST_MEMORY = 1.5f

        /**
         * What a file takes while MicroPython reads it, mostly for its parse tree: so much, and so much for each byte but
         * for spaces at the beginning of a line, comments and empty lines. Measured with MicroPython 1.28 for the PC, halved
         * because its words have 64 bits, for programs of 10 to 600 statements: within 7 % (docs/python.md).
         */
        private const val MEMORY_AT_LEAST = 500
        private const val MEMORY_PER_BYTE = 3.4

        /** A file takes chunks of [CHUNK] bytes, [CHUNK_DATA] of them data, and begins with its name and length. */
        private const val CHUNK = 128
        private const val CHUNK_DATA = 126
        private const val FILE_HEAD = 10

        /** How many calls fit inside each other: 1,800 and 7,680 bytes of stack, estimates. */
        private const val DEEPEST_CALLS_V1 = 5
        private const val DEEPEST_CALLS_V2 = 30

        fun deepestCallsOn(model: MicrobitModel): Int =
            if (model == MicrobitModel.V1) DEEPEST_CALLS_V1 else DEEPEST_CALLS_V2

        fun of(model: MicrobitModel, python: String): BoardRoom {
            // The longest main.py beside nothing else.
            val mostBytes = model.fileBytes / CHUNK * CHUNK_DATA - FILE_HEAD
            val code = python.lineSequence().map { it.trim().substringBefore("  # ") }
                .filter { it.isNotEmpty() && !it.startsWith('#') }
            val memory = MEMORY_AT_LEAST + (code.sumOf { it.encodeToByteArray().size + 1 } * MEMORY_PER_BYTE).toInt()
            return BoardRoom(memory, model.heapBytes, python.encodeToByteArray().size, mostBytes)
        }
    }
}
