package robotran.microbit.hardware

import robotran.brick.controls.BrickButton
import robotran.microbit.model.MicrobitButton
import robotran.microbit.model.MicrobitModel

/** The buttons of a micro:bit. */
internal class BoardButtons(private val model: MicrobitModel) {
    private var hidden = emptySet<MicrobitButton>()

    /** What fingers hold down. */
    var pressed: Set<BrickButton> = emptySet()
        private set

    /** Whether a program sees that [button] is down. */
    fun isDown(button: MicrobitButton): Boolean = button.control in pressed && button !in hidden

    /** Sets whether [button] is held down. Returns which one of the board it is; null if nothing changed. */
    fun hold(button: BrickButton, down: Boolean): MicrobitButton? {
        val own = model.buttons.find { it.control == button } ?: return null
        if (button in pressed == down) return null
        pressed = if (down) pressed + button else pressed - button
        if (!down) hidden = hidden - own
        return own
    }

    /** A program starts: the press that started it is not for it. */
    fun startRun() {
        hidden = model.buttons.filterTo(mutableSetOf()) { it.control in pressed }
    }
}
