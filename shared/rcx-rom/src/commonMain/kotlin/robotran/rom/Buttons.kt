package robotran.rom

/** Which buttons of the brick are held down. */
internal class Buttons {
    var pressed: Set<BrickButton> = emptySet()
        private set

    /** Sets whether [button] is held down; false if it is so already. */
    fun hold(button: BrickButton, down: Boolean): Boolean {
        if (button in pressed == down) return false
        pressed = if (down) pressed + button else pressed - button
        return true
    }
}
