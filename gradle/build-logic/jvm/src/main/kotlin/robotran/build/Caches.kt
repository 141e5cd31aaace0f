package robotran.build

import org.gradle.api.Project
import java.io.File
import java.security.MessageDigest

/** The folder outside the tree for build tools that all checkouts share. The scripts use the same folder. */
fun cacheDirectory(project: Project): File {
    val base = project.providers.environmentVariable("XDG_CACHE_HOME").orNull
    // The scripts use HOME, which may differ from Java's user.home.
    val home = project.providers.environmentVariable("HOME").orNull ?: System.getProperty("user.home")
    return File(base ?: File(home, ".cache").path, "robotran")
}

/** The first twelve hexadecimal digits of the SHA-256 of [file]. */
fun shortHash(file: File): String = sha256(file).take(12)

/** The SHA-256 of [file] in hexadecimal digits. */
fun sha256(file: File): String =
    MessageDigest.getInstance("SHA-256").digest(file.readBytes()).joinToString("") { "%02x".format(it) }
