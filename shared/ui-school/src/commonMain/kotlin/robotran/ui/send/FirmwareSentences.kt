package robotran.ui.send

import androidx.compose.runtime.Composable
import robotran.tower.Remains
import robotran.tower.firmware.FirmwareFile
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.state.ChosenFirmware

/** What the file [chosen] is, where LEGO's own firmware is needed, or else leJOS. */
@Composable
internal fun firmwareSentence(chosen: ChosenFirmware, needsLego: Boolean): String = when (val file = chosen.file) {
    is FirmwareFile.Failure -> if (needsLego) {
        SendTexts.fileLegoNone(
            spoken,
            chosen.name,
        )
    } else {
        SendTexts.firmwareNone(spoken, chosen.name)
    }

    is FirmwareFile.Success -> if (needsLego) {
        forLego(
            chosen.name,
            file.firmware,
        )
    } else {
        forLejos(chosen.name, file.firmware)
    }
}

@Composable
private fun forLejos(name: String, firmware: FirmwareImage) = when (firmware.kind) {
    FirmwareKind.LEJOS_3_0 -> SendTexts.firmwareLejos30(spoken, name)
    FirmwareKind.LEJOS_2_1 -> SendTexts.firmwareLejos21(spoken, name)
    FirmwareKind.UNKNOWN -> SendTexts.firmwareUnknown(spoken, name)
    FirmwareKind.LEGO -> SendTexts.firmwareLego(spoken, name)
}

@Composable
private fun forLego(name: String, firmware: FirmwareImage) = when (firmware.kind) {
    FirmwareKind.LEJOS_3_0, FirmwareKind.LEJOS_2_1 -> SendTexts.fileLejos(spoken, name)
    FirmwareKind.UNKNOWN -> SendTexts.fileLegoUnknown(spoken, name)
    FirmwareKind.LEGO -> legoVersion(name, firmware)
}

@Composable
private fun legoVersion(name: String, firmware: FirmwareImage): String {
    val version = firmware.version ?: return SendTexts.fileLego(spoken, name)
    val isTooOld = ChosenFirmware.isTooOld(firmware)
    val words = if (isTooOld) SendTexts::fileLegoOld else SendTexts::fileLegoVersion
    return words(spoken, name, "$version")
}

/** What the brick has after a transfer that has failed; null if it has what it had before. */
@Composable
internal fun remainsSentence(remains: Remains, slot: Int?): String? = when (remains) {
    Remains.AS_BEFORE -> null
    Remains.NO_FIRMWARE -> SendTexts.leftNoFirmware(spoken)

    Remains.NO_PROGRAM -> slot?.let { SendTexts.leftEmptySlot(spoken, it) }
        ?: SendTexts.leftNothing(spoken)

    Remains.UNKNOWN -> slot?.let { SendTexts.leftUnknownSlot(spoken, it) }
        ?: SendTexts.leftUnknown(spoken)
}
