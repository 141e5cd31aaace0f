package robotran.assignments.collecting

/**
 * A file that a teacher has collected.
 *
 * @property path its name, with the folders that it lies in, separated by `/`. A folder ends with one.
 */
class CollectedFile(val path: String, val bytes: ByteArray)

/** The limits of [collectHandIns]. What exceeds one is an unusable submission; the others still count. */
object CollectingLimits {
    const val MAXIMUM_SUBMISSIONS = 500

    /** For a file inside a zip that is not a zip itself. A project has at most three million. */
    const val MAXIMUM_FILE_BYTES = 4_000_000

    /** For everything that a zip unpacks to, zips inside it included. */
    const val MAXIMUM_ZIP_BYTES = 64_000_000

    /** The same for a zip inside another, such as that of one pupil. */
    const val MAXIMUM_INNER_ZIP_BYTES = 16_000_000

    /** For one zip. */
    const val MAXIMUM_ENTRIES = 5_000

    /** For all files together, also those from zips. */
    const val MAXIMUM_FILES = 20_000

    /** A zip in a zip in a zip. */
    const val MAXIMUM_DEPTH = 3

    /** For one file. */
    const val MAXIMUM_LINKS = 500
}
