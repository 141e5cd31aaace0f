package robotran.microbitlink

/** How a board numbers its errors, which has changed with DAPLink 0254. */
enum class DaplinkNumbers(internal val ends: Set<Int>) {
    OLDER(setOf(16)),
    NEWER(setOf(19)),

    /** A V1 that does not tell: most likely it has the older ones. */
    UNKNOWN(setOf(16, 19)),
    ;

    /** What [number] means, which is neither 0 nor the end of the file. */
    fun kindOf(number: Int): RefusalKind = COMMON[number] ?: if (this == NEWER) newerKind(number) else olderKind(number)

    private fun olderKind(number: Int): RefusalKind = when (number) {
        in 7..10 -> RefusalKind.RESET
        11, 12 -> RefusalKind.LOCKED
        in 13..15 -> RefusalKind.WRITING
        18 -> RefusalKind.CHECKSUM
        in 19..22 -> RefusalKind.NOT_FOR_THIS_BOARD
        25 -> RefusalKind.UNKNOWN_FILE
        23, 24, in 26..33 -> RefusalKind.UPDATE
        else -> RefusalKind.UNKNOWN
    }

    private fun newerKind(number: Int): RefusalKind = when (number) {
        in 7..12 -> RefusalKind.RESET
        13, 14 -> RefusalKind.LOCKED
        in 15..18 -> RefusalKind.WRITING
        21 -> RefusalKind.CHECKSUM
        in 22..25 -> RefusalKind.NOT_FOR_THIS_BOARD
        28 -> RefusalKind.UNKNOWN_FILE
        29 -> RefusalKind.OTHER_BOARD
        26, 27, in 30..37 -> RefusalKind.UPDATE
        else -> RefusalKind.UNKNOWN
    }

    companion object {
        /** The first version with the newer numbers. */
        private const val FIRST_NEWER = 254

        /** How [board] with the version [daplink] numbers its errors. */
        fun of(board: MicrobitBoard, daplink: Int?): DaplinkNumbers = when {
            daplink != null -> if (daplink >= FIRST_NEWER) NEWER else OLDER
            board == MicrobitBoard.V2 -> NEWER
            else -> UNKNOWN
        }

        private val COMMON = mapOf(
            1 to RefusalKind.INTERNAL,
            2 to RefusalKind.INTERNAL,
            3 to RefusalKind.TRANSFER,
            4 to RefusalKind.TIMED_OUT,
            5 to RefusalKind.SIZE,
            6 to RefusalKind.OUT_OF_ORDER,
        )
    }
}
