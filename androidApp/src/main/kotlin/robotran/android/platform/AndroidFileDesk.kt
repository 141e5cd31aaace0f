package robotran.android.platform

import android.content.ContentResolver
import android.content.Intent
import android.net.Uri
import android.provider.OpenableColumns
import androidx.activity.ComponentActivity
import androidx.activity.result.ActivityResultLauncher
import androidx.activity.result.contract.ActivityResultContracts
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.documents.FileKind
import robotran.ui.platform.FileDesk
import robotran.ui.platform.OpenedFile
import robotran.ui.platform.Saving
import java.io.IOException

/**
 * Files through Android's own picker (Storage Access Framework); places are content addresses. An activity that shows the workshop attaches itself, and a
 * new one takes over what an old one has asked for.
 */
class AndroidFileDesk(
    private val resolver: ContentResolver,
) : FileDesk {
    private var opener: ActivityResultLauncher<Array<String>>? = null
    private var creators: Map<String, ActivityResultLauncher<String>> = emptyMap()
    private var chosen = CompletableDeferred<List<Uri>>()

    /** To be called in `onCreate`. */
    fun attachTo(activity: ComponentActivity) {
        opener = activity.registerForActivityResult(ActivityResultContracts.OpenMultipleDocuments()) { chosen.complete(it) }
        creators =
            FileKind.entries.map { it.mimeType }.distinct().associateWith { type ->
                activity.registerForActivityResult(ActivityResultContracts.CreateDocument(type)) { chosen.complete(listOfNotNull(it)) }
            }
    }

    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> {
        // Android knows none of our kinds, so all files can be chosen, and what cannot be opened is refused in words.
        val places = ask { opener?.launch(arrayOf("*/*")) }
        return places.mapNotNull { readFile(it) }
    }

    override suspend fun save(
        name: String,
        kind: FileKind,
        bytes: ByteArray,
    ): Saving {
        val place = ask { creators[kind.mimeType]?.launch(name) }.firstOrNull() ?: return Saving.GivenUp
        return write(place.toString(), nameOf(place), bytes)
    }

    override suspend fun write(
        place: String,
        name: String,
        bytes: ByteArray,
    ): Saving =
        withContext(Dispatchers.IO) {
            try {
                val address = Uri.parse(place)
                val stream = resolver.openOutputStream(address, "wt") ?: return@withContext Saving.Failed("")
                stream.use { it.write(bytes) }
                keepAccess(address)
                Saving.Saved(name, place)
            } catch (problem: IOException) {
                Saving.Failed(problem.message.orEmpty(), isFull = FULL in problem.message.orEmpty())
            } catch (problem: SecurityException) {
                Saving.Failed(problem.message.orEmpty())
            }
        }

    override suspend fun read(place: String): ByteArray? = withContext(Dispatchers.IO) { bytesAt(Uri.parse(place)) }

    /** The file at [place]; null if it cannot be read. */
    suspend fun readFile(place: Uri): OpenedFile? =
        withContext(Dispatchers.IO) {
            keepAccess(place)
            bytesAt(place)?.let { OpenedFile(nameOf(place), it, place.toString()) }
        }

    private suspend fun ask(launch: () -> Unit): List<Uri> {
        chosen.complete(emptyList())
        chosen = CompletableDeferred()
        launch()
        return chosen.await()
    }

    private fun bytesAt(place: Uri): ByteArray? =
        try {
            resolver.openInputStream(place)?.use { stream -> stream.readUpTo(LARGEST_FILE) }
        } catch (_: IOException) {
            null
        } catch (_: SecurityException) {
            null
        }

    private fun java.io.InputStream.readUpTo(most: Int): ByteArray? {
        val bytes = java.io.ByteArrayOutputStream()
        val part = ByteArray(PART)
        while (bytes.size() <= most) {
            val length = read(part)
            if (length < 0) return bytes.toByteArray()
            bytes.write(part, 0, length)
        }
        return null
    }

    /** So that Save works the next time too, where the other app allows it. */
    private fun keepAccess(place: Uri) {
        runCatching {
            resolver.takePersistableUriPermission(place, Intent.FLAG_GRANT_READ_URI_PERMISSION or Intent.FLAG_GRANT_WRITE_URI_PERMISSION)
        }
    }

    private fun nameOf(place: Uri): String {
        val found =
            runCatching {
                resolver.query(place, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null)?.use { row ->
                    if (row.moveToFirst()) row.getString(0) else null
                }
            }.getOrNull()
        return found ?: place.lastPathSegment.orEmpty().substringAfterLast('/')
    }

    private companion object {
        const val LARGEST_FILE = 16_000_000
        const val PART = 65_536
        const val FULL = "ENOSPC"
    }
}
