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
    data class Success(val bytes: Int, val repeats: Int) : TransferResult

    /** The brick has not confirmed everything. [remains] is what it holds instead. */
    data class Failure(val error: TowerError, val remains: Remains = Remains.AS_BEFORE) : TransferResult
}

/** What a brick holds after a transfer that has failed. */
enum class Remains {
    /** Nothing was changed. */
    AS_BEFORE,

    /** It has no program that it could run; with LEGO's firmware, none in the slot that was sent to. */
    NO_PROGRAM,

    /** It has no firmware, and so no programs. */
    NO_FIRMWARE,

    /** What was sent, what was there before, or nothing: the brick was not heard any more. */
    UNKNOWN,
}

/** What can go wrong between app and brick. */
sealed interface TowerError {
    /** The port is gone: unplugged in the middle. */
    data object TowerGone : TowerError

    /** A serial port that echoes nothing: no tower, no battery in it, or another device. */
    data object TowerSilent : TowerError

    /** The tower works, but no brick answers: off, too far, or in bright light. */
    data object BrickSilent : TowerError

    /** A brick answers, but without leJOS's firmware. It has LEGO's of version [lego], or none if that is null. */
    data class NoLejos(val lego: RcxVersion? = null) : TowerError

    /** A brick answers, but without LEGO's firmware, which the request needs: it has leJOS or no firmware. */
    data object NoLegoFirmware : TowerError

    /** The program is for LEGO's firmware 2.0, and the brick has [version], an earlier one. */
    data class LegoFirmwareTooOld(val version: RcxVersion) : TowerError

    /** Answers came, but too many were damaged or lost: light, distance, a second brick, weak batteries. */
    data object BadConnection : TowerError

    /** LEGO's firmware measures less than a transfer needs. */
    data class BatteryLow(val millivolts: Int) : TowerError

    /** The brick has no room: [bytes] were sent or wanted, it takes [maxBytes]; null if it does not tell. */
    data class TooLarge(val bytes: Int, val maxBytes: Int?) : TowerError

    /** The brick refused the firmware at its end: damaged, or not a firmware for the RCX. */
    data object FirmwareRefused : TowerError
}
