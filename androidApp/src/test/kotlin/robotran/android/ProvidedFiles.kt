package robotran.android

import androidx.core.content.FileProvider

/** Each test has a cache of its own, but the provider of files keeps the place of the first. */
internal fun forgetProvidedFiles() {
    val kept = FileProvider::class.java.getDeclaredField("sCache").apply { isAccessible = true }.get(null)
    (kept as MutableMap<*, *>).clear()
}
