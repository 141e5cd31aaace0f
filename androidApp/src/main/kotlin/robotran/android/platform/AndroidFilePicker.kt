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
 * Files through Android's own picker (Storage Access Framework); places are content addresses. An activity that shows
 * the workshop attaches itself, and a new one takes over what an old one has asked for.
 *
 * @param arrivals is brought what is chosen when nobody waits for it any more, since the process was ended behind the
 * picker.
 * @param unreadable a sentence that says that the file with this name cannot be read.
 */
class AndroidFilePicker internal constructor(
    private val contents: ContentFiles,
    private val arrivals: OpenRequests,
    private val unreadable: (String) -> String,
) : FilePicker {
    private var opener: ActivityResultLauncher<Array<String>>? = null
    private var creators: Map<String, ActivityResultLauncher<String>> = emptyMap()
    private var asked: CompletableDeferred<List<Uri>>? = null

    /** To be called in `onCreate`. */
    fun attachTo(activity: ComponentActivity) {
        opener =
            activity.registerForActivityResult(ActivityResultContracts.OpenMultipleDocuments()) { places ->
                if (!tell(places)) activity.lifecycleScope.launch { bring(places, arrivals) }
            }
        creators =
            FileKind.entries.map { it.mimeType }.distinct().associateWith { type ->
                activity.registerForActivityResult(ActivityResultContracts.CreateDocument(type)) { place ->
                    // What was to be written into it is gone.
                    if (!tell(listOfNotNull(place)) &&
                        place != null
                    ) {
                        activity.lifecycleScope.launch { contents.delete(place) }
                    }
                }
            }
    }

    /** Reads the files at [places] and hands them to [arrivals], together; says which cannot be read. */
    suspend fun bring(places: List<Uri>, arrivals: OpenRequests) {
        val opened = readAll(places, arrivals)
        if (opened.isNotEmpty()) arrivals.bring(OpenRequest.OfFiles(opened))
    }

    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> {
        // Android knows none of our kinds, so all files can be chosen, and what cannot be opened is refused in words.
        return readAll(ask { opener?.launch(arrayOf("*/*")) }.orEmpty(), arrivals)
    }

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving {
        val places = ask { creators[kind.mimeType]?.launch(name) } ?: return Saving.Failed("")
        val place = places.firstOrNull() ?: return Saving.GivenUp
        return contents.write(place, contents.name(place), bytes)
    }

    override suspend fun write(place: String, name: String, bytes: ByteArray): Saving =
        contents.write(Uri.parse(place), name, bytes)

    override suspend fun read(place: String): ByteArray? = contents.bytes(Uri.parse(place))

    private suspend fun readAll(places: List<Uri>, arrivals: OpenRequests): List<OpenedFile> =
        places.take(MAX_FILES).mapNotNull { place ->
            contents.read(place).also {
                if (it ==
                    null
                ) {
                    arrivals.bring(OpenRequest.Unreadable(unreadable(contents.name(place))))
                }
            }
        }

    /** What a person chooses in what [launch] shows; null where Android has no picker. */
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

    /** Tells [places] whoever waits for them; false if nobody does. */
    private fun tell(places: List<Uri>): Boolean = asked?.complete(places).also { asked = null } ?: false

    private companion object {
        /** More than anybody opens at once on purpose. */
        const val MAX_FILES = 100
    }
}
