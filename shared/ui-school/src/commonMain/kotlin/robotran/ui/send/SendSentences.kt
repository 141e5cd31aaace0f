package robotran.ui.send

import androidx.compose.runtime.Composable
import robotran.tower.TowerError
import robotran.tower.port.OpenFailure
import robotran.tower.port.TowerKind
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.state.SendError
import robotran.workshop.state.SendStep
import robotran.workshop.state.Transfer

/** What happens in [step], or what is wrong and what to do, in one sentence or two. */
@Composable
internal fun sentenceOf(step: SendStep): String = when (step) {
    SendStep.Building -> SendTexts.building(spoken)
    is SendStep.HasErrors -> SendTexts.mistake(spoken)
    SendStep.NoCompiler -> SendTexts.noCompiler(spoken)
    SendStep.CompilerFailed -> SendTexts.compilerFailed(spoken)
    SendStep.NoTowers -> SendTexts.noTowers(spoken)

    is SendStep.ChoosingTower -> if (step.isMissing) SendTexts.chooseMissing(spoken) else SendTexts.choose(spoken)

    SendStep.Checking -> SendTexts.checking(spoken)
    is SendStep.ChoosingSlot -> SendTexts.slot(spoken)
    is SendStep.ReadingDatalog -> SendTexts.datalogReading(spoken)

    is SendStep.Datalog -> if (step.entries.isEmpty()) {
        SendTexts.datalogNone(spoken)
    } else {
        SendTexts.datalog(spoken, step.entries.size)
    }

    is SendStep.Sending -> step.what.choose(SendTexts.program(spoken), SendTexts.firmware(spoken))

    is SendStep.NeedsFirmware -> step.file?.let { firmwareSentence(it, step.needsLego) } ?: sentenceOf(step.why)

    is SendStep.Cancelled -> step.slot?.let { SendTexts.cancelledSlot(spoken, it) }
        ?: step.what.choose(SendTexts.cancelledProgram(spoken), SendTexts.cancelledFirmware(spoken))

    is SendStep.Failed -> sentenceOf(step.error)

    is SendStep.Done -> step.slot?.let { SendTexts.doneSlot(spoken, it) }
        ?: SendTexts.done(spoken)

    is SendStep.Watching -> if (step.isOver) SendTexts.watchingOver(spoken) else SendTexts.watching(spoken)
}

/** What else helps in [step]; null for nothing. */
@Composable
internal fun adviceOf(step: SendStep): String? = when (step) {
    is SendStep.HasErrors -> errorText(step.first)

    is SendStep.ChoosingTower -> when {
        TowerKind.USB !in step.kinds -> SendTexts.usbElsewhere(spoken)
        TowerKind.SERIAL !in step.kinds -> SendTexts.serialElsewhere(spoken)
        else -> null
    }

    is SendStep.Sending, is SendStep.ReadingDatalog -> SendTexts.keepStill(spoken)

    is SendStep.Datalog -> step.savedAs?.let { SendTexts.datalogSaved(spoken, it) }
        ?: SendTexts.datalogRefused(spoken).takeIf { step.isRefused }

    is SendStep.ChoosingSlot -> SendTexts.slotHelp(spoken)

    is SendStep.NeedsFirmware -> if (step.needsLego) {
        SendTexts.legoWhere(spoken)
    } else {
        SendTexts.firmwareWhere(spoken).takeIf {
            step.usable ==
                null
        }
    }

    is SendStep.Done -> SendTexts.doneHelp(spoken)

    is SendStep.Failed -> listOfNotNull(
        SendTexts.errorBrickSilentHelp(spoken).takeIf {
            step.error == SendError.OfTower(TowerError.BrickSilent)
        },
        remainsSentence(step.remains, step.slot),
    ).joinToString(" ").ifEmpty { null }

    else -> null
}

@Composable
private fun sentenceOf(error: SendError): String = when (error) {
    is SendError.OfPort -> when (error.failure) {
        OpenFailure.GONE -> SendTexts.errorTowerGone(spoken)
        OpenFailure.BUSY -> SendTexts.errorBusy(spoken)
        OpenFailure.NOT_ALLOWED -> SendTexts.errorNotAllowed(spoken)
        OpenFailure.HELD_BY_DRIVER -> SendTexts.errorHeld(spoken)
    }

    is SendError.OfTower -> sentenceOf(error.error)
}

@Composable
private fun sentenceOf(error: TowerError): String = when (error) {
    TowerError.TowerGone -> SendTexts.errorTowerGone(spoken)
    TowerError.TowerSilent -> SendTexts.errorTowerSilent(spoken)
    TowerError.BrickSilent -> SendTexts.errorBrickSilent(spoken)

    is TowerError.NoLejos -> error.lego?.let { SendTexts.hasLego(spoken, "$it") }
        ?: SendTexts.needsFirmware(spoken)

    TowerError.NoLegoFirmware -> SendTexts.needsLego(spoken)
    is TowerError.LegoFirmwareTooOld -> SendTexts.legoTooOld(spoken, "${error.version}")
    TowerError.BadConnection -> SendTexts.errorConnection(spoken)
    is TowerError.BatteryLow -> SendTexts.errorBattery(spoken, voltsOf(error.millivolts))

    is TowerError.TooLarge -> error.maxBytes?.let { SendTexts.errorLarge(spoken, error.bytes, it) }
        ?: SendTexts.fullSlots(spoken)

    TowerError.FirmwareRefused -> SendTexts.errorRefused(spoken)
}

private fun Transfer.choose(program: String, firmware: String): String = when (this) {
    Transfer.PROGRAM -> program
    Transfer.FIRMWARE -> firmware
}
