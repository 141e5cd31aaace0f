package robotran.microbitlink

/** What can go wrong between app and board. Each has a sentence. */
sealed interface BoardError {
    /** The board was unplugged, or is not there. */
    data object OutOfReach : BoardError

    /** Another app, window or page uses the board. */
    data object Taken : BoardError

    /** The system or the user does not let the app use the board. */
    data object NotAllowed : BoardError

    /** The program that receives programs is too old: the board can only be used as a drive. */
    data object InterfaceTooOld : BoardError

    /** Another board with the same kind of interface. */
    data object NotAMicrobit : BoardError

    /** The file cannot go onto this board. */
    data class BadFile(val error: ImageError) : BoardError

    /** The board was unplugged while a program was sent. */
    data object BrokenOff : BoardError

    /** The board does not answer, or answers something else. */
    data object BadConnection : BoardError

    /** The board refuses what it gets. [number] is what it says. */
    data class Refused(val number: Int, val kind: FlashErrorKind) : BoardError

    /** Python does not answer: there is none on the board, or its program cannot be interrupted. */
    data object NoPython : BoardError

    /** The files of the board leave too little room. */
    data object NoRoom : BoardError

    /** What the board says that it holds is not what was sent, or it was misunderstood. */
    data object NotAsSent : BoardError
}

/** The result of asking a board something. */
sealed interface BoardResult<out T> {
    data class Success<T>(val value: T) : BoardResult<T>

    data class Failure(val error: BoardError) : BoardResult<Nothing>
}

/** The result of sending a program. */
sealed interface SendResult {
    /** The board holds exactly what was sent. [attempts] is 1 if nothing had to be repeated. */
    data class Success(val attempts: Int) : SendResult

    /** The board has not confirmed everything. [remains] is what it holds instead. */
    data class Failure(val error: BoardError, val remains: Remains = Remains.AS_BEFORE) : SendResult
}

/** What a board holds after something was sent to it. */
enum class Remains {
    /** What it held before. */
    AS_BEFORE,

    /** A part of what was sent, or nothing of it; perhaps no whole program. It must be sent again. */
    PART,

    /** What was sent, what was there before, or a part: it has all been sent, but the board has not confirmed it. */
    UNKNOWN,

    /** Exactly what was sent. */
    AS_SENT,
}

/** How far a program is. */
data class SendProgress(val sent: Int, val total: Int, val attempt: Int)

/**
 * What a connected board is.
 *
 * @property serialNumber 48 hexadecimal digits.
 * @property daplink the version of the program that receives programs, such as 257; null if it does not tell, as old ones.
 */
data class BoardDescription(val board: MicrobitBoard, val serialNumber: String, val daplink: Int?)
