package robotran.cli.brick

import robotran.cli.messages.TowerMessages
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.firmware.FirmwareFileError
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind

/** What went wrong between tower and brick, and what to do. */
internal fun TowerMessages.sentence(error: TowerError): String = when (error) {
    TowerError.TowerGone -> towerGone()
    TowerError.TowerSilent -> towerSilent()
    TowerError.BrickSilent -> brickSilent()
    is TowerError.NoLejos -> error.lego?.let { legoInsteadOfLejos("$it") } ?: noLejos()
    TowerError.NoLegoFirmware -> noLegoFirmware()
    is TowerError.LegoFirmwareTooOld -> legoFirmwareTooOld("${error.version}")
    TowerError.BadConnection -> badConnection()
    is TowerError.BatteryLow -> batteryLow(volts(error.millivolts))
    is TowerError.TooLarge -> error.maxBytes?.let { programTooLarge(error.bytes, it) } ?: brickFull(error.bytes)
    TowerError.FirmwareRefused -> firmwareRefused()
}

/** What a brick has after a transfer that has failed; [slot] is that of LEGO's firmware that was sent to. */
internal fun TowerMessages.sentence(remains: Remains, slot: Int?): String = when (remains) {
    Remains.AS_BEFORE -> remainsAsBefore()
    Remains.NO_PROGRAM -> slot?.let { remainsEmptySlot(it) } ?: remainsNoProgram()
    Remains.NO_FIRMWARE -> remainsNoFirmware()
    Remains.UNKNOWN -> slot?.let { remainsUnknownSlot(it) } ?: remainsUnknown()
}

/** Why the file [name] is no firmware. */
internal fun TowerMessages.sentence(error: FirmwareFileError, name: String): String = when (error) {
    FirmwareFileError.NotSRecords -> notAFirmware(name)
    is FirmwareFileError.DamagedLine -> firmwareDamaged(name, error.line)
    FirmwareFileError.CutOff -> firmwareCutOff(name)
    is FirmwareFileError.OutOfRange -> firmwareOutOfRange(name, error.line)
    is FirmwareFileError.TooLarge -> firmwareTooLarge(name, error.bytes, error.maxBytes)
    FirmwareFileError.NoRomText -> firmwareForOthers(name)
}

/** Which firmware the file [name] is. */
internal fun TowerMessages.sentence(firmware: FirmwareImage, name: String): String = when (firmware.kind) {
    FirmwareKind.LEJOS_2_1 -> firmwareIs(name, "leJOS 2.1")
    FirmwareKind.LEJOS_3_0 -> firmwareIs(name, "leJOS 3.0")
    FirmwareKind.LEGO -> firmwareIs(name, listOfNotNull("LEGO's firmware", firmware.version).joinToString(" "))
    FirmwareKind.UNKNOWN -> firmwareUnknown(name)
}

/** Volts with one decimal: 8.7. */
internal fun volts(millivolts: Int): String =
    "${millivolts / MILLIVOLTS}.${millivolts % MILLIVOLTS * TENTHS / MILLIVOLTS}"

private const val MILLIVOLTS = 1000
private const val TENTHS = 10
