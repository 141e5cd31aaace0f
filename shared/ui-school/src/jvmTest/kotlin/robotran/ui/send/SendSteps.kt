package robotran.ui.send

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.legofirmware.device.DatalogEntry
import robotran.tower.RcxVersion
import robotran.tower.ReceivedMessage
import robotran.tower.Remains
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

/** An entry of each kind, and more than fit on the sheet. */
private val DATALOG = listOf(0x40, 0x20, 0x1F, 0x80, 0x99).map { DatalogEntry(it, it * 3) } +
    List(70) { DatalogEntry(0x41, 40 + it % 15) }

/** One step of each kind, and each error, by a name for its picture. */
internal val SEND_STEPS: Map<String, SendStep> = buildMap {
    put("building", SendStep.Building)
    put("mistake", SendStep.HasErrors(Diagnostic(Severity.ERROR, "Square.java", SourceRange(12, 5, 9), TOO_LARGE)))
    put("no-compiler", SendStep.NoCompiler)
    put("compiler-failed", SendStep.CompilerFailed)
    put("error-full", SendStep.Failed(SendError.OfTower(TowerError.TooLarge(9_000, null))))
    put("error-left", SendStep.Failed(SendError.OfTower(TowerError.BrickSilent), Remains.UNKNOWN, slot = 2))
    put("error-no-program", SendStep.Failed(SendError.OfTower(TowerError.TowerGone), Remains.NO_PROGRAM, slot = 5))
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
    put("slot", SendStep.ChoosingSlot(last = null))
    put("slot-again", SendStep.ChoosingSlot(last = 4))
    put("datalog-reading", SendStep.ReadingDatalog(TransferProgress(50, 123, 0, 3)))
    put("datalog", SendStep.Datalog(DATALOG))
    put("datalog-saved", SendStep.Datalog(DATALOG, savedAs = "datalog.csv"))
    put("datalog-refused", SendStep.Datalog(DATALOG.take(2), isRefused = true))
    put("datalog-none", SendStep.Datalog(emptyList()))
    put("needs-firmware", SendStep.NeedsFirmware())
    put("has-lego", SendStep.NeedsFirmware(why = TowerError.NoLejos(RcxVersion(3, 28))))
    put("needs-lego", SendStep.NeedsFirmware(why = TowerError.NoLegoFirmware))
    put("lego-too-old", SendStep.NeedsFirmware(why = TowerError.LegoFirmwareTooOld(RcxVersion(3, 9))))
    for (kind in FirmwareKind.entries) {
        val file = FirmwareFile.Success(FirmwareImage(ByteArray(1), 0x8000, kind))
        put("firmware-${kind.name.lowercase()}", SendStep.NeedsFirmware(ChosenFirmware("lejos.srec", file)))
        put(
            "lego-${kind.name.lowercase()}",
            SendStep.NeedsFirmware(ChosenFirmware("firm0328.lgo", file), TowerError.NoLegoFirmware),
        )
    }
    for (minor in listOf(9, 28)) {
        val file = FirmwareFile.Success(FirmwareImage(ByteArray(1), 0x8000, FirmwareKind.LEGO, RcxVersion(3, minor)))
        val chosen = ChosenFirmware("firm03$minor.lgo", file)
        put("lego-3-$minor", SendStep.NeedsFirmware(chosen, TowerError.NoLegoFirmware))
    }
    val none = FirmwareFile.Failure(FirmwareFileError.NotSRecords)
    put("firmware-none", SendStep.NeedsFirmware(ChosenFirmware("square.robo", none)))
    put("lego-none", SendStep.NeedsFirmware(ChosenFirmware("square.robo", none), TowerError.NoLegoFirmware))
    put("cancelled-slot", SendStep.Cancelled(Transfer.PROGRAM, slot = 3))
    put("done-slot", SendStep.Done(240, slot = 2))
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
