package robotran.documents

/**
 * A file on this device that the user has chosen.
 *
 * @property address locates it on the platform: a path or a content URI; never shown.
 * @property name the file name, without folders.
 */
data class FileReference(val address: String, val name: String)

/**
 * The file that a project was opened from or saved to.
 *
 * @property stamp of its content at that time; a different stamp now means that another program has changed it.
 */
data class SaveTarget(val place: FileReference, val stamp: FileStamp)
