package robotran.uikit

/** The tags of components that make tags of their own, by which tests and the page find what is on the screen. */
object KitTags {
    const val DOCUMENT_DIALOG = "document-dialog"

    fun at(tag: String, place: Int) = "$tag-$place"

    fun close(tag: String) = "$tag-close"
}
