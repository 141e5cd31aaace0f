package robotran.microbitlink

/** How a board numbers its errors, which has changed with DAPLink 0254. */
enum class DaplinkNumbers(internal val ends: Set<Int>) {
    OLDER(setOf(16)),
    NEWER(setOf(19)),

    /** A V1 that does not tell: most likely it has the older ones. */
    UNKNOWN(setOf(16, 19)),
    ;

    /** What [number] means, which is neither 0 nor the end of the file. */
    fun kindOf(number: Int): FlashErrorKind =
        COMMON[number] ?: if (this == NEWER) newerKind(number) else olderKind(number)

    private fun olderKind(number: Int): FlashErrorKind = when (number) {
        in 7..10 -> FlashErrorKind.RESET
        11, 12 -> FlashErrorKind.LOCKED
        in 13..15 -> FlashErrorKind.WRITING
        18 -> FlashErrorKind.CHECKSUM
        in 19..22 -> FlashErrorKind.NOT_FOR_THIS_BOARD
        25 -> FlashErrorKind.UNKNOWN_FILE
        23, 24, in 26..33 -> FlashErrorKind.UPDATE
        else -> FlashErrorKind.UNKNOWN
    }

    private fun newerKind(number: Int): FlashErrorKind = when (number) {
        in 7..12 -> FlashErrorKind.RESET
        13, 14 -> FlashErrorKind.LOCKED
        in 15..18 -> FlashErrorKind.WRITING
        21 -> FlashErrorKind.CHECKSUM
        in 22..25 -> FlashErrorKind.NOT_FOR_THIS_BOARD
        28 -> FlashErrorKind.UNKNOWN_FILE
        29 -> FlashErrorKind.OTHER_BOARD
        26, 27, in 30..37 -> FlashErrorKind.UPDATE
        else -> FlashErrorKind.UNKNOWN
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
            1 to FlashErrorKind.INTERNAL,
            2 to FlashErrorKind.INTERNAL,
            3 to FlashErrorKind.TRANSFER,
            4 to FlashErrorKind.TIMED_OUT,
            5 to FlashErrorKind.SIZE,
            6 to FlashErrorKind.OUT_OF_ORDER,
        )
    }
}
