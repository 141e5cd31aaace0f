package robotran.simulation.robot

import robotran.simulation.noise.NoiseStream
import robotran.simulation.noise.Realism
import robotran.world.Penbot

/**
 * A bumper's switch: pressed at the first touch, released a moment after the last. Its contact bounces for some
 * milliseconds whenever it closes or opens, longer in a more realistic world.
 */
internal class Bumper(private val stream: NoiseStream, private val realism: Double) {
    private var untilOut = 0
    private var bounces = 0

    val isPressed: Boolean get() = untilOut > 0

    /** Whether its contact is closed, as the brick measures it. */
    var isClosed = false
        private set

    /** Number of bounces of its contact. */
    var bounceCount = 0
        private set

    /** Advances by one tick. */
    fun tick(touching: Boolean) {
        if (!touching && untilOut == 0 && bounces == 0 && !isClosed) return
        val wasPressed = isPressed
        untilOut = if (touching) Penbot.BUMPER_RETURN else maxOf(0, untilOut - 1)
        if (isPressed != wasPressed && realism > 0) {
            bounces = (realism * Realism.BOUNCE_MILLISECONDS * stream.share()).toInt() + 1
        }
        val wasClosed = isClosed
        isClosed = isPressed
        if (bounces > 0) {
            bounces--
            if (stream.share() < HALF) isClosed = !isPressed
            if (isClosed != wasClosed && isClosed != isPressed) bounceCount++
        }
    }

    private companion object {
        const val HALF = 0.5
    }
}
