package robotran.world

import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.WheelTrim

/**
 * The buggy of a robot with a micro:bit.
 *
 * @property trim by what its programs slow down the faster wheel; the other one is slower by that, also in the simulation.
 * @property pins those of a [BuggyKind.PLAIN] one, if the pupil has named them.
 */
data class BuggyMount(val kind: BuggyKind, val trim: WheelTrim = WheelTrim.NONE, val pins: BuggyPins? = null) {
    companion object {
        /** The range of both factors of a trim. */
        val TRIMS: ClosedFloatingPointRange<Double> = 0.5..1.0
    }
}
