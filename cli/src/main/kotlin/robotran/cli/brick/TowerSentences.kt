package robotran.cli.brick

import robotran.cli.messages.TowerMessages
import robotran.tower.TowerError
import robotran.tower.firmware.FirmwareFileError
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind

/** What went wrong between tower and brick, and what to do. */
internal fun TowerMessages.sentence(error: TowerError): String = when (error) {
    TowerError.TowerGone -> towerGone()
    TowerError.TowerSilent -> towerSilent()
    TowerError.BrickSilent -> brickSilent()
    TowerError.NoLejos -> noLejos()
    TowerError.NoLegoFirmware -> noLegoFirmware()
    TowerError.BadConnection -> badConnection()
    is TowerError.BatteryLow -> batteryLow(volts(error.millivolts))
    is TowerError.TooLarge -> error.maxBytes?.let { programTooLarge(error.bytes, it) } ?: brickFull(error.bytes)
    TowerError.FirmwareRefused -> firmwareRefused()
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
    FirmwareKind.LEGO -> firmwareIs(name, "LEGO's firmware")
    FirmwareKind.UNKNOWN -> firmwareUnknown(name)
}

/** Volts with one decimal: 8.7. */
internal fun volts(millivolts: Int): String =
    "${millivolts / MILLIVOLTS}.${millivolts % MILLIVOLTS * TENTHS / MILLIVOLTS}"

private const val MILLIVOLTS = 1000
private const val TENTHS = 10
