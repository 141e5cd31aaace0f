package robotran.workshop.platform

/** How text leaves the app. */
interface Sharing {
    /**
     * Whether the platform has a way of sharing of its own beside the clipboard, such as the share sheet of a phone.
     */
    val hasShareSheet: Boolean get() = false

    /** Copies [text] to the clipboard; whether that worked. */
    suspend fun copy(text: String): Boolean = share(text)

    /** Hands [text] to the platform's way of sharing, or copies it where there is none; whether that worked. */
    suspend fun share(text: String): Boolean
}

/** Where text cannot leave. */
object NoSharing : Sharing {
    override suspend fun share(text: String): Boolean = false
}
