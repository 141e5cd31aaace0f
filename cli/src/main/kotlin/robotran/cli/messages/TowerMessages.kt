package robotran.cli.messages

/** Messages about the infrared tower and a real brick. Each `port` is as the user or the system names it. */
internal interface TowerMessages {
    /** A slot was asked for, but leJOS has none. */
    fun lejosHasNoSlots(): String

    /** Programs for leJOS and for LEGO's own firmware were named together. */
    fun twoFirmwares(): String

    /** From slot [first] on there are not [programs] slots; the last one is [last]. */
    fun tooFewSlots(first: Int, programs: Int, last: Int): String

    fun noTower(): String

    /** The ports echo nothing. */
    fun noTowerAt(ports: List<String>): String

    fun portGone(port: String): String

    fun portBusy(port: String): String

    fun portNotAllowed(port: String): String

    fun portHeld(port: String): String

    fun towerAt(port: String): String

    fun blocksSent(sent: Int, all: Int, secondsLeft: Int): String

    fun programSent(bytes: Int): String

    fun programInSlot(bytes: Int, slot: Int): String

    fun entriesRead(read: Int, all: Int, secondsLeft: Int): String

    /** The datalog has no entries, or there is none. */
    fun noDatalog(): String

    fun datalogWritten(name: String, entries: Int): String

    /** @param time hours and minutes. */
    fun clockSet(time: String): String

    fun notATime(text: String): String

    fun slotEmptied(slot: Int): String

    fun firmwareSent(bytes: Int): String

    /** @param firmware its name and version. */
    fun firmwareIs(name: String, firmware: String): String

    fun firmwareUnknown(name: String): String

    fun notAFirmware(name: String): String

    fun firmwareDamaged(name: String, line: Int): String

    fun firmwareCutOff(name: String): String

    fun firmwareOutOfRange(name: String, line: Int): String

    fun firmwareTooLarge(name: String, bytes: Int, limit: Int): String

    fun firmwareForOthers(name: String): String

    fun towerGone(): String

    fun towerSilent(): String

    fun brickSilent(): String

    fun noLejos(): String

    /** The brick has LEGO's firmware [version], and needs leJOS. */
    fun legoInsteadOfLejos(version: String): String

    fun noLegoFirmware(): String

    /** The brick has firmware [version], and the program is for firmware 2.0. */
    fun legoFirmwareTooOld(version: String): String

    /** What the brick has after a transfer that has failed. */
    fun remainsAsBefore(): String

    fun remainsNoProgram(): String

    fun remainsEmptySlot(slot: Int): String

    fun remainsNoFirmware(): String

    fun remainsUnknown(): String

    fun remainsUnknownSlot(slot: Int): String

    fun badConnection(): String

    fun batteryLow(volts: String): String

    fun programTooLarge(bytes: Int, limit: Int): String

    fun brickFull(bytes: Int): String

    fun firmwareRefused(): String

    /** @param rom the version of the ROM. */
    fun brickHasLejosOrNothing(rom: String): String

    fun brickHasLego(firmware: String, rom: String): String

    fun batteryIs(volts: String): String

    fun brickIsUnknown(): String
}
