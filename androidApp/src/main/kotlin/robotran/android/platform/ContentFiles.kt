package robotran.android.platform

import android.content.ContentResolver
import android.content.Intent
import android.net.Uri
import android.provider.DocumentsContract
import android.provider.OpenableColumns
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.Saving
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.InputStream

/** Files at content URIs. Handles all exceptions of other apps' providers. */
internal class ContentFiles(private val resolver: ContentResolver) {
    /** The file at [place]; null if it cannot be read or exceeds the size limit. */
    suspend fun read(place: Uri): OpenedFile? = withContext(Dispatchers.IO) {
        keepAccess(place)
        bytesAt(place)?.let { OpenedFile(nameOf(place), it, place.toString()) }
    }

    suspend fun bytes(place: Uri): ByteArray? = withContext(Dispatchers.IO) { bytesAt(place) }

    /** The display name of the file at [place]. */
    suspend fun name(place: Uri): String = withContext(Dispatchers.IO) { nameOf(place) }

    /** Writes [bytes] to the file at [place]. On failure restores the previous content. */
    suspend fun write(place: Uri, name: String, bytes: ByteArray): Saving = withContext(Dispatchers.IO) {
        val before = bytesAt(place)
        val problem = guarded { put(place, bytes) }
        if (problem == null) {
            keepAccess(place)
            Saving.Saved(name, place.toString())
        } else {
            if (before != null) guarded { put(place, before) }
            Saving.Failed(problem.message.orEmpty(), isFull = FULL in problem.message.orEmpty())
        }
    }

    /** Deletes a file that was created but not written. */
    suspend fun delete(place: Uri) {
        withContext(Dispatchers.IO) { guarded { DocumentsContract.deleteDocument(resolver, place) } }
    }

    private fun put(place: Uri, bytes: ByteArray) {
        val stream = resolver.openOutputStream(place, "wt") ?: throw IOException("")
        stream.use { it.write(bytes) }
    }

    private fun bytesAt(place: Uri): ByteArray? {
        var bytes: ByteArray? = null
        guarded { bytes = resolver.openInputStream(place)?.use { it.readUpTo(LARGEST_FILE) } }
        return bytes
    }

    /** Keeps the permission for later saves, if the other app allows it. */
    private fun keepAccess(place: Uri) {
        val access = Intent.FLAG_GRANT_READ_URI_PERMISSION or Intent.FLAG_GRANT_WRITE_URI_PERMISSION
        guarded { resolver.takePersistableUriPermission(place, access) }
    }

    private fun nameOf(place: Uri): String {
        var found: String? = null
        guarded {
            val rows = resolver.query(place, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null)
            rows?.use { if (it.moveToFirst()) found = it.getString(0) }
        }
        return found ?: place.lastPathSegment.orEmpty().substringAfterLast('/')
    }

    /** Runs [action] and returns its exception; null on success. */
    private fun guarded(action: () -> Unit): Exception? = try {
        action()
        null
    } catch (problem: IOException) {
        problem
    } catch (problem: RuntimeException) {
        // Providers pass their own exceptions to callers.
        problem
    }

    private fun InputStream.readUpTo(max: Int): ByteArray? {
        val bytes = ByteArrayOutputStream()
        val part = ByteArray(PART)
        while (bytes.size() <= max) {
            val length = read(part)
            if (length < 0) return bytes.toByteArray()
            bytes.write(part, 0, length)
        }
        return null
    }

    private companion object {
        const val LARGEST_FILE = 16_000_000
        const val PART = 65_536
        const val FULL = "ENOSPC"
    }
}
