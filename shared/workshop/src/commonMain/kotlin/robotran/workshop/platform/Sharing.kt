package robotran.workshop.platform

/** Shares text with other apps. */
interface Sharing {
    /** Whether the platform has a share sheet in addition to the clipboard, such as on a phone. */
    val hasShareSheet: Boolean get() = false

    /** Copies [text] to the clipboard. Returns whether it succeeded. */
    suspend fun copy(text: String): Boolean = share(text)

    /** Passes [text] to the share sheet, or copies it if there is none. Returns whether it succeeded. */
    suspend fun share(text: String): Boolean
}

/** A platform without sharing. */
object NoSharing : Sharing {
    override suspend fun share(text: String): Boolean = false
}
