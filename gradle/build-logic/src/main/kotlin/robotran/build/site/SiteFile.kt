package robotran.build.site

import java.io.File
import java.security.MessageDigest
import java.util.Base64

/** A file of the built site that never changes, since what is in it is in its name. */
internal class SiteFile private constructor(
    /** What is in it. */
    val content: File,
    /** Its name in the folder `files`. */
    val name: String,
) {
    /** Where the page finds it. */
    val address: String get() = "$FOLDER/$name"

    companion object {
        /** The folder that holds all such files. */
        const val FOLDER = "files"

        private const val DIGITS = 16
        private val NAMED_BY_CONTENT = Regex(""".+\.[0-9a-f]{16}\.\w+""")

        /**
         * [file] under its own name if webpack has put into it what is in the file, else with the beginning of its
         * SHA-256 in it.
         */
        fun of(file: File): SiteFile = SiteFile(
            file,
            if (NAMED_BY_CONTENT.matches(file.name)) {
                file.name
            } else {
                "${file.nameWithoutExtension}.${hexOf(sha256(file.readBytes())).take(DIGITS)}.${file.extension}"
            },
        )
    }
}

/** What a browser compares a fetched file with, or a script in the page: `sha256-` and Base64. */
internal fun integrityOf(bytes: ByteArray): String = "sha256-" + Base64.getEncoder().encodeToString(sha256(bytes))

internal fun sha256(bytes: ByteArray): ByteArray = MessageDigest.getInstance("SHA-256").digest(bytes)

internal fun hexOf(bytes: ByteArray): String = bytes.joinToString("") { "%02x".format(it) }
