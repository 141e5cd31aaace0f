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
    /** The file at [uri]; null if it cannot be read or exceeds the size limit. */
    suspend fun read(uri: Uri): OpenedFile? = withContext(Dispatchers.IO) {
        keepAccess(uri)
        bytesAt(uri)?.let { OpenedFile(nameOf(uri), it, uri.toString()) }
    }

    suspend fun bytes(uri: Uri): ByteArray? = withContext(Dispatchers.IO) { bytesAt(uri) }

    /** The display name of the file at [uri]. */
    suspend fun name(uri: Uri): String = withContext(Dispatchers.IO) { nameOf(uri) }

    /** Writes [bytes] to the file at [uri]. On failure restores the previous content. */
    suspend fun write(uri: Uri, name: String, bytes: ByteArray): Saving = withContext(Dispatchers.IO) {
        val before = bytesAt(uri)
        val problem = guarded { put(uri, bytes) }
        if (problem == null) {
            keepAccess(uri)
            Saving.Saved(name, uri.toString())
        } else {
            if (before != null) guarded { put(uri, before) }
            Saving.Failed(problem.message.orEmpty(), isFull = FULL in problem.message.orEmpty())
        }
    }

    /** Deletes a file that was created but not written. */
    suspend fun delete(uri: Uri) {
        withContext(Dispatchers.IO) { guarded { DocumentsContract.deleteDocument(resolver, uri) } }
    }

    private fun put(uri: Uri, bytes: ByteArray) {
        val stream = resolver.openOutputStream(uri, "wt") ?: throw IOException("")
        stream.use { it.write(bytes) }
    }

    private fun bytesAt(uri: Uri): ByteArray? {
        var bytes: ByteArray? = null
        guarded { bytes = resolver.openInputStream(uri)?.use { it.readUpTo(LARGEST_FILE) } }
        return bytes
    }

    /** Keeps the permission for later saves, if the other app allows it. */
    private fun keepAccess(uri: Uri) {
        val access = Intent.FLAG_GRANT_READ_URI_PERMISSION or Intent.FLAG_GRANT_WRITE_URI_PERMISSION
        guarded { resolver.takePersistableUriPermission(uri, access) }
    }

    private fun nameOf(uri: Uri): String {
        var found: String? = null
        guarded {
            val rows = resolver.query(uri, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null)
            rows?.use { if (it.moveToFirst()) found = it.getString(0) }
        }
        return found ?: uri.lastPathSegment.orEmpty().substringAfterLast('/')
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
