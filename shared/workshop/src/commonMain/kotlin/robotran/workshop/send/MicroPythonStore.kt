package robotran.workshop.send

import kotlinx.coroutines.withContext
import robotran.documents.FileKind
import robotran.documents.KeyValueStore
import robotran.documents.StoreResult
import robotran.microbitlink.ImageError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.image.MicroPythonFile
import robotran.microbitlink.image.MicroPythonImage
import robotran.workshop.platform.Platform
import robotran.workshop.state.FoundMicroPython
import kotlin.coroutines.CoroutineContext

/** The file with MicroPython that the pupil chooses once. It is kept on this device, as it was opened. */
internal class MicroPythonStore(private val platform: Platform) {
    private val store: KeyValueStore get() = platform.store
    val background: CoroutineContext get() = platform.background

    /** What was chosen, now or earlier; null if nothing was. */
    var chosen: ChosenMicroPython? = null
        private set

    private var isRead = false

    /** Reads what was kept, once. */
    suspend fun read() {
        if (isRead) return
        store.read(NAME)?.let { kept ->
            val text = kept.substringAfter('\n')
            val file = withContext(platform.background) { MicroPythonFile.read(text) }
            if (file is ImageResult.Success) chosen = ChosenMicroPython(kept.substringBefore('\n'), file.value)
        }
        // Only now: a sheet that was closed meanwhile has read nothing.
        isRead = true
    }

    /** Lets the pupil choose a file. What was chosen before stays if this one is no good. */
    suspend fun choose(): ChoosingResult {
        val opened = platform.files.open(listOf(FileKind.HEX)).firstOrNull() ?: return ChoosingResult.Cancelled
        if (opened.bytes.size > LARGEST) return ChoosingResult.Failure(opened.name, ImageError.NotHex)
        val text = opened.bytes.decodeToString()
        return when (val file = withContext(platform.background) { MicroPythonFile.read(text) }) {
            is ImageResult.Failure -> ChoosingResult.Failure(opened.name, file.error)

            is ImageResult.Success -> {
                chosen = ChosenMicroPython(opened.name, file.value)
                ChoosingResult.Success(isKept = store.write(NAME, "${oneLine(opened.name)}\n$text") == StoreResult.Done)
            }
        }
    }

    private fun oneLine(name: String) = name.map { if (it.isISOControl()) ' ' else it }.joinToString("")

    private companion object {
        const val NAME = "micropython.hex"

        /** In bytes: a universal hex with MicroPython has 1.9 million. */
        const val LARGEST = 10_000_000
    }
}

/** @property name of its file. */
internal class ChosenMicroPython(val name: String, val file: MicroPythonFile) {
    val found: FoundMicroPython by lazy {
        FoundMicroPython(name, file.images.mapValues { (board, image) -> versionFor(board) ?: image.shortVersion })
    }

    private fun versionFor(board: MicrobitBoard): String? = when (board) {
        MicrobitBoard.V1 -> file.release?.v1
        MicrobitBoard.V2 -> file.release?.v2
    }
}

/** Such as 2.1.2 of "micro:bit v2.1.2+1234 on 2024-01-01; MicroPython v1.18 on 2024-01-01". */
private val MicroPythonImage.shortVersion: String get() = VERSION.find(version)?.groupValues?.get(1).orEmpty()

private val VERSION = Regex("""micro:bit v(\d+(?:\.\d+)*)""")

/** The result of choosing a file with MicroPython. */
internal sealed interface ChoosingResult {
    /** @property isKept whether it serves the next time, too. */
    class Success(val isKept: Boolean) : ChoosingResult

    class Failure(val file: String, val error: ImageError) : ChoosingResult

    data object Cancelled : ChoosingResult
}
