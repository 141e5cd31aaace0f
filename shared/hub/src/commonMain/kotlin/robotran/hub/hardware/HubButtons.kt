package robotran.hub.hardware

import robotran.brick.controls.BrickButton
import robotran.hub.model.HubButton
import robotran.hub.model.HubModel

/** The buttons of a hub, and which of them stops a program. */
internal class HubButtons(private val model: HubModel) {
    private var hidden = emptySet<HubButton>()

    /** The buttons that fingers hold down. */
    var pressed: Set<BrickButton> = emptySet()
        private set

    /** What a program sees. */
    var seen: Set<HubButton> = emptySet()
        private set

    /** The button that stops the program; null for none. */
    var stopButton: HubButton? = model.stopButton
        private set

    /** Sets whether [button] is held down. Returns which one of the hub it is; null if nothing changed. */
    fun hold(button: BrickButton, down: Boolean): HubButton? {
        val own = model.buttons.find { it.control == button } ?: return null
        if (button in pressed == down) return null
        pressed = if (down) pressed + button else pressed - button
        if (!down) hidden = hidden - own
        look()
        return own
    }

    /** A program starts: the button that started it is not for it. */
    fun startRun() {
        stopButton = model.stopButton
        hidden = model.buttons.filterTo(mutableSetOf()) { it.control in pressed }
        look()
    }

    /** Returns false if the hub has no such button. */
    fun setStopButton(button: HubButton?): Boolean {
        if (button != null && button !in model.buttons) return false
        stopButton = button
        look()
        return true
    }

    private fun look() {
        seen = model.buttons.filterTo(mutableSetOf()) {
            it.control in pressed && it !in hidden && it != stopButton && it != HubButton.BACK
        }
    }
}
