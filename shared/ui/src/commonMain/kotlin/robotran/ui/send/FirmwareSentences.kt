package robotran.ui.send

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.tower.Remains
import robotran.tower.firmware.FirmwareFile
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind
import robotran.ui.resources.*
import robotran.workshop.state.ChosenFirmware

/** What the file [chosen] is, where LEGO's own firmware is needed, or else leJOS. */
@Composable
internal fun firmwareSentence(chosen: ChosenFirmware, needsLego: Boolean): String = when (val file = chosen.file) {
    is FirmwareFile.Rejected -> stringResource(
        if (needsLego) Res.string.send_file_lego_none else Res.string.send_firmware_none,
        chosen.name,
    )

    is FirmwareFile.Read -> if (needsLego) forLego(chosen.name, file.firmware) else forLejos(chosen.name, file.firmware)
}

@Composable
private fun forLejos(name: String, firmware: FirmwareImage) = stringResource(
    when (firmware.kind) {
        FirmwareKind.LEJOS_3_0 -> Res.string.send_firmware_lejos_3_0
        FirmwareKind.LEJOS_2_1 -> Res.string.send_firmware_lejos_2_1
        FirmwareKind.UNKNOWN -> Res.string.send_firmware_unknown
        FirmwareKind.LEGO -> Res.string.send_firmware_lego
    },
    name,
)

@Composable
private fun forLego(name: String, firmware: FirmwareImage) = when (firmware.kind) {
    FirmwareKind.LEJOS_3_0, FirmwareKind.LEJOS_2_1 -> stringResource(Res.string.send_file_lejos, name)
    FirmwareKind.UNKNOWN -> stringResource(Res.string.send_file_lego_unknown, name)
    FirmwareKind.LEGO -> legoVersion(name, firmware)
}

@Composable
private fun legoVersion(name: String, firmware: FirmwareImage): String {
    val version = firmware.version ?: return stringResource(Res.string.send_file_lego, name)
    val isTooOld = ChosenFirmware.isTooOld(firmware)
    val words = if (isTooOld) Res.string.send_file_lego_old else Res.string.send_file_lego_version
    return stringResource(words, name, "$version")
}

/** What the brick has after a transfer that has failed; null if it has what it had before. */
@Composable
internal fun remainsSentence(remains: Remains, slot: Int?): String? = when (remains) {
    Remains.AS_BEFORE -> null
    Remains.NO_FIRMWARE -> stringResource(Res.string.send_left_no_firmware)

    Remains.NO_PROGRAM -> slot?.let { stringResource(Res.string.send_left_empty_slot, it) }
        ?: stringResource(Res.string.send_left_nothing)

    Remains.UNKNOWN -> slot?.let { stringResource(Res.string.send_left_unknown_slot, it) }
        ?: stringResource(Res.string.send_left_unknown)
}
