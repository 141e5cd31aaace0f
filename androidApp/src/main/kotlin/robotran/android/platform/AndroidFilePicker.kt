package robotran.android.platform

import android.content.ActivityNotFoundException
import android.net.Uri
import androidx.activity.ComponentActivity
import androidx.activity.result.ActivityResultLauncher
import androidx.activity.result.contract.ActivityResultContracts
import androidx.lifecycle.lifecycleScope
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.launch
import robotran.documents.FileKind
import robotran.workshop.platform.FilePicker
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenRequests
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.Saving

/**
 * Opens and saves files with Android's picker (Storage Access Framework); locations are content URIs. The activity that
 * shows the workshop attaches itself; a new activity receives the results of an old one's requests.
 *
 * @param openRequests receives files chosen for a request that was lost because the process ended behind the picker.
 * @param unreadable the error message for a file name.
 */
class AndroidFilePicker internal constructor(
    private val contents: ContentFiles,
    private val openRequests: OpenRequests,
    private val unreadable: (String) -> String,
) : FilePicker {
    private var opener: ActivityResultLauncher<Array<String>>? = null
    private var creators: Map<String, ActivityResultLauncher<String>> = emptyMap()
    private var asked: CompletableDeferred<List<Uri>>? = null

    /** Must be called in `onCreate`. */
    fun attachTo(activity: ComponentActivity) {
        opener =
            activity.registerForActivityResult(ActivityResultContracts.OpenMultipleDocuments()) { places ->
                if (!tell(places)) activity.lifecycleScope.launch { bring(places, openRequests) }
            }
        creators =
            FileKind.entries.map { it.mimeType }.distinct().associateWith { type ->
                activity.registerForActivityResult(ActivityResultContracts.CreateDocument(type)) { location ->
                    // The data to write was lost with the process.
                    if (!tell(listOfNotNull(location)) && location != null) {
                        activity.lifecycleScope.launch { contents.delete(location) }
                    }
                }
            }
    }

    /** Reads the files at [places], passes them to [openRequests] in one request and reports unreadable ones. */
    suspend fun bring(places: List<Uri>, openRequests: OpenRequests) {
        val opened = readAll(places, openRequests)
        if (opened.isNotEmpty()) openRequests.bring(OpenRequest.OfFiles(opened))
    }

    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> {
        // Android does not know our file types, so all files can be chosen. Unsupported files are rejected with a
        // message.
        return readAll(ask { opener?.launch(arrayOf("*/*")) }.orEmpty(), openRequests)
    }

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving {
        val places = ask { creators[kind.mimeType]?.launch(name) } ?: return Saving.Failed("")
        val location = places.firstOrNull() ?: return Saving.Cancelled
        return contents.write(location, contents.name(location), bytes)
    }

    override suspend fun write(location: String, name: String, bytes: ByteArray): Saving =
        contents.write(Uri.parse(location), name, bytes)

    override suspend fun read(location: String): ByteArray? = contents.bytes(Uri.parse(location))

    private suspend fun readAll(places: List<Uri>, openRequests: OpenRequests): List<OpenedFile> =
        places.take(MAX_FILES).mapNotNull { location ->
            contents.read(location).also {
                if (it == null) {
                    openRequests.bring(OpenRequest.Unreadable(unreadable(contents.name(location))))
                }
            }
        }

    /** The user's choice in the picker that [launch] shows; null if Android has no picker. */
    private suspend fun ask(launch: () -> Unit): List<Uri>? {
        asked?.complete(emptyList())
        val answer = CompletableDeferred<List<Uri>>()
        asked = answer
        try {
            launch()
        } catch (_: ActivityNotFoundException) {
            asked = null
            return null
        }
        return answer.await()
    }

    /** Completes the pending request with [places]; false if there is none. */
    private fun tell(places: List<Uri>): Boolean = asked?.complete(places).also { asked = null } ?: false

    private companion object {
        /** More files than anyone opens at once on purpose. */
        const val MAX_FILES = 100
    }
}
