package robotran.ui.send

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.tower.TowerError
import robotran.tower.port.OpenFailure
import robotran.tower.port.TowerKind
import robotran.ui.resources.*
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
    is SendStep.ChoosingSlot -> stringResource(Res.string.send_slot)
    is SendStep.ReadingDatalog -> stringResource(Res.string.send_datalog_reading)

    is SendStep.Datalog -> if (step.entries.isEmpty()) {
        stringResource(Res.string.send_datalog_none)
    } else {
        stringResource(Res.string.send_datalog, step.entries.size)
    }

    is SendStep.Sending -> stringResource(
        step.what.choose(Res.string.send_program, Res.string.send_firmware),
    )

    is SendStep.NeedsFirmware -> step.file?.let { firmwareSentence(it, step.needsLego) } ?: sentenceOf(step.why)

    is SendStep.Cancelled -> step.slot?.let { stringResource(Res.string.send_cancelled_slot, it) } ?: stringResource(
        step.what.choose(Res.string.send_cancelled_program, Res.string.send_cancelled_firmware),
    )

    is SendStep.Failed -> sentenceOf(step.error)

    is SendStep.Done -> step.slot?.let { stringResource(Res.string.send_done_slot, it) }
        ?: stringResource(Res.string.send_done)

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

    is SendStep.Sending, is SendStep.ReadingDatalog -> stringResource(Res.string.send_keep_still)

    is SendStep.Datalog -> step.savedAs?.let { stringResource(Res.string.send_datalog_saved, it) }
        ?: stringResource(Res.string.send_datalog_refused).takeIf { step.isRefused }

    is SendStep.ChoosingSlot -> stringResource(Res.string.send_slot_help)

    is SendStep.NeedsFirmware -> stringResource(
        if (step.needsLego) Res.string.send_lego_where else Res.string.send_firmware_where,
    ).takeIf { step.usable == null }

    is SendStep.Done -> stringResource(Res.string.send_done_help)

    is SendStep.Failed -> listOfNotNull(
        stringResource(Res.string.send_error_brick_silent_help).takeIf {
            step.error == SendError.OfTower(TowerError.BrickSilent)
        },
        remainsSentence(step.remains, step.slot),
    ).joinToString(" ").ifEmpty { null }

    else -> null
}

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

    is TowerError.NoLejos -> error.lego?.let { stringResource(Res.string.send_has_lego, "$it") }
        ?: stringResource(Res.string.send_needs_firmware)

    TowerError.NoLegoFirmware -> stringResource(Res.string.send_needs_lego)
    is TowerError.LegoFirmwareTooOld -> stringResource(Res.string.send_lego_too_old, "${error.version}")
    TowerError.BadConnection -> stringResource(Res.string.send_error_connection)
    is TowerError.BatteryLow -> stringResource(Res.string.send_error_battery, voltsOf(error.millivolts))

    is TowerError.TooLarge -> error.maxBytes?.let { stringResource(Res.string.send_error_large, error.bytes, it) }
        ?: stringResource(Res.string.send_full_slots)

    TowerError.FirmwareRefused -> stringResource(Res.string.send_error_refused)
}

private fun Transfer.choose(program: StringResource, firmware: StringResource): StringResource = when (this) {
    Transfer.PROGRAM -> program
    Transfer.FIRMWARE -> firmware
}
