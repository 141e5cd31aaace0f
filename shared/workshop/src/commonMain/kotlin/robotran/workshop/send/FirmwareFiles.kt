package robotran.workshop.send

import robotran.documents.FileKind
import robotran.workshop.platform.FilePicker
import robotran.workshop.state.ChosenFirmware

/** Lets the pupil choose a firmware file. */
internal class FirmwareFiles(private val files: FilePicker, private val robots: RobotLinks) {
    /** The chosen file and its content; null if the pupil chose none. */
    suspend fun choose(): Pair<ChosenFirmware, ByteArray>? {
        val file = files.open(listOf(FileKind.FIRMWARE, FileKind.LEGO_FIRMWARE)).firstOrNull() ?: return null
        return ChosenFirmware(file.name, robots.recognise(file.bytes)) to file.bytes
    }
}
