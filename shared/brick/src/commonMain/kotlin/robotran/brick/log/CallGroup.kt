package robotran.brick.log

import robotran.brick.kind.BrickKind

/**
 * The subject of a call; [CallLogFilter] selects log entries by it.
 *
 * @property kinds the bricks that have such calls.
 */
enum class CallGroup(val kinds: Set<BrickKind> = BrickKind.entries.toSet()) {
    SENSORS,
    MOTORS,
    BUTTONS,
    DISPLAY,
    SOUND,
    POWER,
    INFRARED(setOf(BrickKind.RCX)),
    TIMER(setOf(BrickKind.RCX)),
    BLUETOOTH(setOf(BrickKind.NXT)),

    /** Exits, exceptions and what a program prints. */
    SYSTEM(setOf(BrickKind.NXT)),

    /** Calls of addresses without a known routine. */
    UNKNOWN(setOf(BrickKind.RCX)),
    ;

    companion object {
        /** The groups of a [kind] of brick. */
        fun of(kind: BrickKind): List<CallGroup> = entries.filter { kind in it.kinds }
    }
}
