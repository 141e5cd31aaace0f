package robotran.nxt.hardware

import robotran.brick.controls.BrickButton

/**
 * The four buttons. The three grey ones share a wire, so the brick sees only one of them: ESCAPE before RIGHT before
 * LEFT. A program sees a state that has lasted for 50 milliseconds; the brick looks every 2.
 */
internal class Buttons {
    /** The buttons that fingers hold down. */
    var pressed: Set<BrickButton> = emptySet()
        private set

    /** What a program sees: bits 1 ENTER, 2 LEFT, 4 RIGHT, 8 ESCAPE. */
    var debounced = 0
        private set

    private var seen = 0
    private var seenFor = 0
    private var hidden = emptySet<BrickButton>()

    /** Sets whether [button] is held down. Returns false if nothing changed or the brick has no such button. */
    fun hold(button: BrickButton, down: Boolean): Boolean {
        if (button !in BITS || button in pressed == down) return false
        pressed = if (down) pressed + button else pressed - button
        if (!down) hidden = hidden - button
        return true
    }

    /** Hides the buttons that are down from a program that starts, until they have been let go. */
    fun hidePressed() {
        hidden = pressed
        debounced = 0
        seen = 0
        seenFor = 0
    }

    /** Looks at the wires; call it every [LOOK_MILLISECONDS]. */
    fun look() {
        val now = onWires()
        if (now != seen) {
            seen = now
            seenFor = 0
        } else if (seen != debounced) {
            seenFor += LOOK_MILLISECONDS
            if (seenFor >= DEBOUNCE_MILLISECONDS) debounced = seen
        }
    }

    private fun onWires(): Int {
        if (pressed.isEmpty()) return 0
        val grey = GREY.firstOrNull { it in pressed && it !in hidden }
        val enter = BrickButton.ENTER.takeIf { it in pressed && it !in hidden }
        return (grey?.let(BITS::getValue) ?: 0) or (enter?.let(BITS::getValue) ?: 0)
    }

    companion object {
        const val LOOK_MILLISECONDS = 2
        private const val DEBOUNCE_MILLISECONDS = 50

        /** The grey buttons, the one that the brick sees first. */
        private val GREY = listOf(BrickButton.ESCAPE, BrickButton.RIGHT, BrickButton.LEFT)

        private val BITS = mapOf(
            BrickButton.ENTER to 1,
            BrickButton.LEFT to 2,
            BrickButton.RIGHT to 4,
            BrickButton.ESCAPE to 8,
        )
    }
}
