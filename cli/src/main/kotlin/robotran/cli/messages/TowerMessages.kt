package robotran.cli.messages

/** Messages about the infrared tower and a real brick. Each `port` is as the user or the system names it. */
internal interface TowerMessages {
    /** A slot was asked for, but leJOS has none. */
    fun lejosHasNoSlots(): String

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

    /** A program of LEGO's firmware got into a slot, 1 to 5. */
    fun programInSlot(slot: Int, bytes: Int): String

    /** The programs need more slots than there are. */
    fun tooFewSlots(slots: Int): String

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

    fun noLegoFirmware(): String

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
