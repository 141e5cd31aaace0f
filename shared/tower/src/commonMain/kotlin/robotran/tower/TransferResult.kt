package robotran.tower

/** How far a transfer is. Times are estimates from the blocks that are through. */
data class TransferProgress(
    /** Blocks that the brick has confirmed. */
    val confirmedBlocks: Int,
    val totalBlocks: Int,
    /** Attempts that had to be repeated so far: a measure of how well tower and brick see each other. */
    val repeats: Int,
    val secondsLeft: Int,
)

/** The result of sending a program or a firmware. */
sealed interface TransferResult {
    /** The brick has confirmed everything that was sent. */
    data class Complete(val bytes: Int, val repeats: Int) : TransferResult

    /** The brick does not hold a complete program or firmware, as far as the tower can know. */
    data class Failed(val error: TowerError) : TransferResult
}

/** What can go wrong between app and brick. */
sealed interface TowerError {
    /** The port is gone: unplugged in the middle. */
    data object TowerGone : TowerError

    /** A serial port that echoes nothing: no tower, no battery in it, or another device. */
    data object TowerSilent : TowerError

    /** The tower works, but no brick answers: off, too far, or in bright light. */
    data object BrickSilent : TowerError

    /** A brick answers, but without leJOS's firmware: LEGO's, or none. */
    data object NoLejos : TowerError

    /** A brick answers, but not with LEGO's firmware, which the request needs. */
    data object NoLegoFirmware : TowerError

    /** Answers came, but too many were damaged or lost: light, distance, a second brick, weak batteries. */
    data object BadConnection : TowerError

    /** LEGO's firmware measures less than a transfer needs. */
    data class BatteryLow(val millivolts: Int) : TowerError

    /** The brick has no room: [bytes] were sent or wanted, it takes [maxBytes]; null if it does not tell. */
    data class TooLarge(val bytes: Int, val maxBytes: Int?) : TowerError

    /** The brick refused the firmware at its end: damaged, or not a firmware for the RCX. */
    data object FirmwareRefused : TowerError
}
