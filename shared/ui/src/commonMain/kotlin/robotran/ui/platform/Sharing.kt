package robotran.ui.platform

/** How text leaves the app. */
interface Sharing {
    /** Copies [text] to the clipboard, or hands it to the platform's way of sharing; whether that worked. */
    suspend fun share(text: String): Boolean
}

/** Where text cannot leave. */
object NoSharing : Sharing {
    override suspend fun share(text: String): Boolean = false
}
