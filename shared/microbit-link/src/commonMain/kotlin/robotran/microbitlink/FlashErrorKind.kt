package robotran.microbitlink

/** What a number means with which a board refuses a file: after sending, in FAIL.TXT, or on its display. */
enum class FlashErrorKind {
    INTERNAL,
    TRANSFER,
    TIMED_OUT,
    SIZE,
    OUT_OF_ORDER,

    /** The processor does not obey: often something on its pins. */
    RESET,

    /** The file would lock the processor for ever. */
    LOCKED,

    /** Erasing, writing or checking failed. */
    WRITING,
    CHECKSUM,

    /** No hex, or addresses that the board does not have. */
    NOT_FOR_THIS_BOARD,
    UNKNOWN_FILE,
    OTHER_BOARD,

    /** About an update of the program that receives programs. */
    UPDATE,
    UNKNOWN,
    ;

    /** Whether the same file may be taken another time. */
    val mayPass: Boolean get() = this !in LASTING

    companion object {
        /** The meaning of the number on a V2's display: 500 and more. */
        fun ofDisplay(number: Int): FlashErrorKind =
            if (number > DISPLAYED) DaplinkNumbers.NEWER.kindOf(number - DISPLAYED) else UNKNOWN

        private const val DISPLAYED = 500
        private val LASTING = setOf(LOCKED, NOT_FOR_THIS_BOARD, UNKNOWN_FILE, OTHER_BOARD, UPDATE)
    }
}
