package robotran.hublink

/** The result of asking a hub something. */
sealed interface HubResult<out T> {
    data class Success<T>(val value: T) : HubResult<T>

    data class Failure(val error: HubError) : HubResult<Nothing>
}

/** The result of sending a program. */
sealed interface DownloadResult {
    /** The hub has confirmed every byte: it holds exactly this program. [attempts] is 1 if nothing had to be repeated. */
    data class Success(val bytes: Int, val attempts: Int) : DownloadResult

    /** The hub has not confirmed everything. [remains] is what it holds instead. */
    data class Failure(val error: HubError, val remains: Remains = Remains.AS_BEFORE) : DownloadResult
}

/** What the slot of a hub holds after a download that has failed. */
enum class Remains {
    /** Nothing was changed. */
    AS_BEFORE,

    /** No program that it could start. */
    NO_PROGRAM,

    /** What was sent, what was there before, or nothing: the hub was not heard any more. */
    UNKNOWN,
}

/** How far a download is. */
data class DownloadProgress(val confirmedBytes: Int, val totalBytes: Int, val attempt: Int)
