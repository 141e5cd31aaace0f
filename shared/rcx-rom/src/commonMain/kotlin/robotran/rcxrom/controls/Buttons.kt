package robotran.rcxrom.controls

import robotran.brick.controls.BrickButton
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.Registers

/** Which buttons of the brick are held down, and the processor pins that report them. */
internal class Buttons(private val memory: RcxMemory) {
    var pressed: Set<BrickButton> = emptySet()
        private set

    init {
        memory.setBits(Registers.PORT_4, Registers.ON_OFF_RELEASED_BIT, on = true)
    }

    /** Sets whether [button], one of an RCX, is held down. Returns false if nothing changed. */
    fun hold(button: BrickButton, down: Boolean): Boolean {
        if (button in pressed == down) return false
        pressed = if (down) pressed + button else pressed - button
        when (button) {
            BrickButton.ON_OFF -> memory.setBits(Registers.PORT_4, Registers.ON_OFF_RELEASED_BIT, !down)
            BrickButton.RUN -> memory.setBits(Registers.PORT_4, Registers.RUN_BIT, down)
            BrickButton.VIEW -> memory.setBits(Registers.PORT_7, Registers.VIEW_BIT, down)
            BrickButton.PRGM -> memory.setBits(Registers.PORT_7, Registers.PRGM_BIT, down)
            else -> error("An RCX has no $button.")
        }
        return true
    }
}
