package robotran.documents

/**
 * A file that a person has chosen on this device.
 *
 * @property address how the platform finds it again: a path, a content address; never shown.
 * @property name what it is called, without folders.
 */
data class FileReference(val address: String, val name: String)

/**
 * The file that a work was opened from or saved to.
 *
 * @property stamp of what was in it then: if something else is in it now, somebody else has written it.
 */
data class SaveTarget(val place: FileReference, val stamp: FileStamp)
