package robotran.workshop.send

import kotlinx.coroutines.withContext
import robotran.documents.FileKind
import robotran.documents.fileNameFor
import robotran.microbitlink.ImageResult
import robotran.microbitlink.files.MAIN_FILE
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving

/** What became of a file that the pupil was to save. */
internal sealed interface SavedFile {
    class Success(val name: String) : SavedFile

    data object Failure : SavedFile

    data object Cancelled : SavedFile
}

/** The file with MicroPython and [built]; null if there is none, or if the program cannot go into it. */
internal suspend fun MicroPythonStore.hexWith(built: MicrobitTranslation.Success): ByteArray? {
    val file = chosen?.file ?: return null
    val text = withContext(background) { hexOf(file, built) }
    return (text as? ImageResult.Success)?.value?.encodeToByteArray()
}

/** Saves [hex], with the program that is called [program]. */
internal suspend fun Platform.saveHex(program: String, hex: ByteArray): SavedFile =
    saved(files.save(fileNameFor(program, FileKind.HEX), FileKind.HEX, hex))

/** Saves [built] under the name that MicroPython starts with. */
internal suspend fun Platform.saveMain(built: MicrobitTranslation.Success): SavedFile =
    saved(files.save(MAIN_FILE, FileKind.PYTHON, built.bytes))

private fun saved(saving: Saving): SavedFile = when (saving) {
    is Saving.Saved -> SavedFile.Success(saving.name)
    is Saving.Failed -> SavedFile.Failure
    Saving.Cancelled -> SavedFile.Cancelled
}
