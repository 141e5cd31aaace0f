package robotran.workshop.platform

/** Shares text and files with other apps. */
interface Sharing {
    /** Whether the platform has a share sheet in addition to the clipboard, such as on a phone. */
    val hasShareSheet: Boolean get() = false

    /** Copies [text] to the clipboard. Returns whether it succeeded. */
    suspend fun copy(text: String): Boolean = share(text)

    /** Passes [text] to the share sheet, or copies it if there is none. Returns whether it succeeded. */
    suspend fun share(text: String): Boolean

    /** Whether [shareFile] can take files, such as pictures. */
    val canShareFiles: Boolean get() = false

    /**
     * Passes [bytes], a file of [kind] called [name], to the share sheet. Returns whether the sheet took it; what the
     * user then does there, or whether they close it, does not matter.
     */
    suspend fun shareFile(name: String, kind: FileKind, bytes: ByteArray): Boolean = false
}

/** A platform without sharing. */
object NoSharing : Sharing {
    override suspend fun share(text: String): Boolean = false
}
