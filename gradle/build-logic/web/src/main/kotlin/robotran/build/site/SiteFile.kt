package robotran.build.site

import java.io.File
import java.security.MessageDigest
import java.util.Base64

/** An immutable file of the built site, whose name contains a hash of its content. */
internal class SiteFile private constructor(
    val content: File,
    /** Its name in the folder `files`. */
    val name: String,
) {
    /** The URL, relative to the page. */
    val address: String get() = "$FOLDER/$name"

    companion object {
        /** The folder that holds all such files. */
        const val FOLDER = "files"

        private const val DIGITS = 16
        private val NAMED_BY_CONTENT = Regex(""".+\.[0-9a-f]{16}\.\w+""")

        /** Whether webpack has put a hash of its content into the name of [file]. */
        fun isNamedByContent(file: File): Boolean = NAMED_BY_CONTENT.matches(file.name)

        /**
         * Keeps the name of [file] if webpack has put a content hash in it, otherwise adds the start of its SHA-256.
         */
        fun of(file: File): SiteFile = SiteFile(
            file,
            if (isNamedByContent(file)) {
                file.name
            } else {
                "${file.nameWithoutExtension}.${hexOf(sha256(file.readBytes())).take(DIGITS)}.${file.extension}"
            },
        )
    }
}

/** The value of an `integrity` attribute or a policy entry: `sha256-` and Base64. */
internal fun integrityOf(bytes: ByteArray): String = "sha256-" + Base64.getEncoder().encodeToString(sha256(bytes))

internal fun sha256(bytes: ByteArray): ByteArray = MessageDigest.getInstance("SHA-256").digest(bytes)

internal fun hexOf(bytes: ByteArray): String = bytes.joinToString("") { "%02x".format(it) }
