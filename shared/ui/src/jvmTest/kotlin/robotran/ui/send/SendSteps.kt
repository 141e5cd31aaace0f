package robotran.ui.send

import robotran.programs.ProgramDiagnostic
import robotran.robolang.diagnostic.SourceRange
import robotran.tower.ReceivedMessage
import robotran.tower.TowerError
import robotran.tower.TransferProgress
import robotran.tower.firmware.FirmwareFile
import robotran.tower.firmware.FirmwareFileError
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind
import robotran.tower.port.OpenFailure
import robotran.tower.port.TowerKind
import robotran.workshop.send.SERIAL_TOWER
import robotran.workshop.send.USB_TOWER
import robotran.workshop.state.ChosenFirmware
import robotran.workshop.state.RobotMessage
import robotran.workshop.state.SendError
import robotran.workshop.state.SendStep
import robotran.workshop.state.Transfer

private const val TOO_LARGE =
    "This program has 312 constants, and the brick takes 255. Use fewer different texts and large numbers."

private val TOWER_ERRORS = listOf(
    TowerError.TowerGone,
    TowerError.TowerSilent,
    TowerError.BrickSilent,
    TowerError.NoLejos,
    TowerError.NoLegoFirmware,
    TowerError.BadConnection,
    TowerError.BatteryLow(6_420),
    TowerError.TooLarge(15_210, 13_788),
    TowerError.FirmwareRefused,
)

private val MESSAGES = listOf(
    RobotMessage(0, 1_240, ReceivedMessage.Number(5)),
    RobotMessage(1, 2_860, ReceivedMessage.Number(200)),
    RobotMessage(2, 12_030, ReceivedMessage.Packet(listOf(18, 5, 0, -1))),
)

/** One step of each kind, and each error, by a name for its picture. */
internal val SEND_STEPS: Map<String, SendStep> = buildMap {
    put("building", SendStep.Building)
    put("mistake", SendStep.HasErrors(ProgramDiagnostic("Square.java", SourceRange(12, 5, 9), TOO_LARGE)))
    put("no-compiler", SendStep.NoCompiler)
    put("compiler-failed", SendStep.CompilerFailed)
    put("error-full", SendStep.Failed(SendError.OfTower(TowerError.TooLarge(9_000, null))))
    put("no-towers", SendStep.NoTowers)
    put("choose", SendStep.ChoosingTower(emptyList(), TowerKind.entries))
    put("choose-again", SendStep.ChoosingTower(listOf(USB_TOWER, SERIAL_TOWER), TowerKind.entries, isMissing = true))
    put("choose-serial", SendStep.ChoosingTower(emptyList(), listOf(TowerKind.SERIAL)))
    put("choose-usb", SendStep.ChoosingTower(emptyList(), listOf(TowerKind.USB)))
    put("checking", SendStep.Checking)
    put("sending-begins", SendStep.Sending(Transfer.PROGRAM, null))
    put("sending", SendStep.Sending(Transfer.PROGRAM, TransferProgress(7, 25, 0, 36)))
    put("sending-weak", SendStep.Sending(Transfer.PROGRAM, TransferProgress(7, 25, 9, 36)))
    put("sending-firmware", SendStep.Sending(Transfer.FIRMWARE, TransferProgress(20, 87, 1, 131)))
    put("needs-firmware", SendStep.NeedsFirmware())
    for (kind in FirmwareKind.entries) {
        val file = FirmwareFile.Read(FirmwareImage(ByteArray(1), 0x8000, kind))
        put("firmware-${kind.name.lowercase()}", SendStep.NeedsFirmware(ChosenFirmware("lejos.srec", file)))
    }
    val none = FirmwareFile.Rejected(FirmwareFileError.NotSRecords)
    put("firmware-none", SendStep.NeedsFirmware(ChosenFirmware("square.robo", none)))
    for (what in Transfer.entries) put("cancelled-${what.name.lowercase()}", SendStep.Cancelled(what))
    for (failure in OpenFailure.entries) {
        put("port-${failure.name.lowercase()}", SendStep.Failed(SendError.OfPort(failure, TowerKind.USB)))
    }
    for (error in TOWER_ERRORS) {
        put("error-${error::class.simpleName?.lowercase()}", SendStep.Failed(SendError.OfTower(error)))
    }
    put("done", SendStep.Done(1234))
    put("watching", SendStep.Watching(emptyList()))
    put("watching-messages", SendStep.Watching(MESSAGES))
    put("watching-over", SendStep.Watching(MESSAGES, isOver = true))
}
