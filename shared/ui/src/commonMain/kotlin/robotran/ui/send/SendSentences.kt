package robotran.ui.send

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.tower.TowerError
import robotran.tower.firmware.FirmwareFile
import robotran.tower.firmware.FirmwareKind
import robotran.tower.port.OpenFailure
import robotran.tower.port.TowerKind
import robotran.ui.resources.Res
import robotran.ui.resources.send_building
import robotran.ui.resources.send_cancelled_firmware
import robotran.ui.resources.send_cancelled_program
import robotran.ui.resources.send_checking
import robotran.ui.resources.send_choose
import robotran.ui.resources.send_choose_missing
import robotran.ui.resources.send_compiler_failed
import robotran.ui.resources.send_done
import robotran.ui.resources.send_done_help
import robotran.ui.resources.send_error_battery
import robotran.ui.resources.send_error_brick_silent
import robotran.ui.resources.send_error_brick_silent_help
import robotran.ui.resources.send_error_busy
import robotran.ui.resources.send_error_connection
import robotran.ui.resources.send_error_full
import robotran.ui.resources.send_error_held
import robotran.ui.resources.send_error_large
import robotran.ui.resources.send_error_no_lego
import robotran.ui.resources.send_error_not_allowed
import robotran.ui.resources.send_error_refused
import robotran.ui.resources.send_error_tower_gone
import robotran.ui.resources.send_error_tower_silent
import robotran.ui.resources.send_firmware
import robotran.ui.resources.send_firmware_lego
import robotran.ui.resources.send_firmware_lejos_2_1
import robotran.ui.resources.send_firmware_lejos_3_0
import robotran.ui.resources.send_firmware_none
import robotran.ui.resources.send_firmware_unknown
import robotran.ui.resources.send_firmware_where
import robotran.ui.resources.send_keep_still
import robotran.ui.resources.send_mistake
import robotran.ui.resources.send_needs_firmware
import robotran.ui.resources.send_no_compiler
import robotran.ui.resources.send_no_towers
import robotran.ui.resources.send_program
import robotran.ui.resources.send_serial_elsewhere
import robotran.ui.resources.send_usb_elsewhere
import robotran.ui.resources.send_watching
import robotran.ui.resources.send_watching_over
import robotran.workshop.state.ChosenFirmware
import robotran.workshop.state.SendError
import robotran.workshop.state.SendStep
import robotran.workshop.state.Transfer

/** What happens in [step], or what is wrong and what to do, in one sentence or two. */
@Composable
internal fun sentenceOf(step: SendStep): String = when (step) {
    SendStep.Building -> stringResource(Res.string.send_building)

    is SendStep.HasErrors -> stringResource(Res.string.send_mistake)

    SendStep.NoCompiler -> stringResource(Res.string.send_no_compiler)

    SendStep.CompilerFailed -> stringResource(Res.string.send_compiler_failed)

    SendStep.NoTowers -> stringResource(Res.string.send_no_towers)

    is SendStep.ChoosingTower -> stringResource(
        if (step.isMissing) Res.string.send_choose_missing else Res.string.send_choose,
    )

    SendStep.Checking -> stringResource(Res.string.send_checking)

    is SendStep.Sending -> stringResource(
        step.what.choose(Res.string.send_program, Res.string.send_firmware),
    )

    is SendStep.NeedsFirmware -> step.file?.let { sentenceOf(it) } ?: stringResource(Res.string.send_needs_firmware)

    is SendStep.Cancelled -> stringResource(
        step.what.choose(Res.string.send_cancelled_program, Res.string.send_cancelled_firmware),
    )

    is SendStep.Failed -> sentenceOf(step.error)

    is SendStep.Done -> stringResource(Res.string.send_done)

    is SendStep.Watching -> stringResource(
        if (step.isOver) Res.string.send_watching_over else Res.string.send_watching,
    )
}

/** What else helps in [step]; null for nothing. */
@Composable
internal fun adviceOf(step: SendStep): String? = when (step) {
    is SendStep.HasErrors -> mistakeText(step.first)

    is SendStep.ChoosingTower -> when {
        TowerKind.USB !in step.kinds -> stringResource(Res.string.send_usb_elsewhere)
        TowerKind.SERIAL !in step.kinds -> stringResource(Res.string.send_serial_elsewhere)
        else -> null
    }

    is SendStep.Sending -> stringResource(Res.string.send_keep_still)

    is SendStep.NeedsFirmware -> stringResource(Res.string.send_firmware_where).takeIf { step.file?.usable == null }

    is SendStep.Done -> stringResource(Res.string.send_done_help)

    is SendStep.Failed -> stringResource(Res.string.send_error_brick_silent_help).takeIf {
        step.error == SendError.OfTower(TowerError.BrickSilent)
    }

    else -> null
}

@Composable
private fun sentenceOf(chosen: ChosenFirmware): String = stringResource(
    when (val file = chosen.file) {
        is FirmwareFile.Rejected -> Res.string.send_firmware_none

        is FirmwareFile.Read -> when (file.firmware.kind) {
            FirmwareKind.LEJOS_3_0 -> Res.string.send_firmware_lejos_3_0
            FirmwareKind.LEJOS_2_1 -> Res.string.send_firmware_lejos_2_1
            FirmwareKind.UNKNOWN -> Res.string.send_firmware_unknown
            FirmwareKind.LEGO -> Res.string.send_firmware_lego
        }
    },
    chosen.name,
)

@Composable
private fun sentenceOf(error: SendError): String = when (error) {
    is SendError.OfPort -> stringResource(
        when (error.failure) {
            OpenFailure.GONE -> Res.string.send_error_tower_gone
            OpenFailure.BUSY -> Res.string.send_error_busy
            OpenFailure.NOT_ALLOWED -> Res.string.send_error_not_allowed
            OpenFailure.HELD_BY_DRIVER -> Res.string.send_error_held
        },
    )

    is SendError.OfTower -> sentenceOf(error.error)
}

@Composable
private fun sentenceOf(error: TowerError): String = when (error) {
    TowerError.TowerGone -> stringResource(Res.string.send_error_tower_gone)

    TowerError.TowerSilent -> stringResource(Res.string.send_error_tower_silent)

    TowerError.BrickSilent -> stringResource(Res.string.send_error_brick_silent)

    TowerError.NoLejos -> stringResource(Res.string.send_needs_firmware)

    TowerError.NoLegoFirmware -> stringResource(Res.string.send_error_no_lego)

    TowerError.BadConnection -> stringResource(Res.string.send_error_connection)

    is TowerError.BatteryLow -> stringResource(Res.string.send_error_battery, voltsOf(error.millivolts))

    is TowerError.TooLarge -> error.maxBytes?.let { stringResource(Res.string.send_error_large, error.bytes, it) }
        ?: stringResource(Res.string.send_error_full)

    TowerError.FirmwareRefused -> stringResource(Res.string.send_error_refused)
}

private fun Transfer.choose(program: StringResource, firmware: StringResource): StringResource = when (this) {
    Transfer.PROGRAM -> program
    Transfer.FIRMWARE -> firmware
}
