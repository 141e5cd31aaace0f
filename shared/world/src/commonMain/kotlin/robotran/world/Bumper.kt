package robotran.world

/** A bumper's switch: in at the first touch, out again a moment after the last. */
internal class Bumper {
    private var untilOut = 0

    val isPressed: Boolean get() = untilOut > 0

    /** Lets one tick pass. */
    fun tick(touching: Boolean) {
        untilOut = if (touching) Penbot.BUMPER_RETURN else maxOf(0, untilOut - 1)
    }
}
