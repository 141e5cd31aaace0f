package robotran.microbitlink

/** What can be wrong with a file for a board, or with a program that is to go into one. Each has a sentence. */
sealed interface ImageError {
    /** No Intel hex at all. */
    data object NotHex : ImageError

    /** A hex that was changed on its way. [line] counts from 1, if it is one line. */
    data class Damaged(val line: Int?) : ImageError

    /** A hex without its end: it was not copied or downloaded whole. */
    data object Incomplete : ImageError

    /** A hex without MicroPython, such as a program of another editor. */
    data object NoMicroPython : ImageError

    /** A hex for other boards than the micro:bit, or not for the one that is [wanted]. */
    data class OtherBoard(val wanted: MicrobitBoard?) : ImageError

    /** A MicroPython that is older than its file system as we know it. */
    data object TooOld : ImageError

    /** Files inside that do not fit together, or a name twice. */
    data object BrokenFiles : ImageError

    /** The program is larger than the room, which is that of the smaller board if it is for both. */
    data class TooLarge(val bytes: Int, val maxBytes: Int) : ImageError

    /** A file system holds no empty file. */
    data class EmptyFile(val name: String) : ImageError

    /** A name has 1 to 120 bytes. */
    data class BadName(val name: String) : ImageError
}

/** What became of a file. */
sealed interface ImageResult<out T> {
    data class Success<T>(val value: T) : ImageResult<T>

    data class Failure(val error: ImageError) : ImageResult<Nothing>
}
