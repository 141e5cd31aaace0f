package robotran.workshop.send

import robotran.documents.FileKind
import robotran.tower.firmware.readFirmwareFile
import robotran.workshop.platform.FilePicker
import robotran.workshop.state.ChosenFirmware

/** Lets the pupil choose a firmware file. Null if the pupil chooses none. */
internal suspend fun FilePicker.chooseFirmware(): ChosenFirmware? {
    val file = open(listOf(FileKind.FIRMWARE, FileKind.LEGO_FIRMWARE)).firstOrNull() ?: return null
    return ChosenFirmware(file.name, readFirmwareFile(file.bytes))
}
