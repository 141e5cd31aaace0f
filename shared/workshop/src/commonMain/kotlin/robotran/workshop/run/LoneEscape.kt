package robotran.workshop.run

import robotran.brick.controls.BrickButton

/** Notices that ESCAPE is pressed without ENTER while a program of an NXT runs, once per run. */
internal class LoneEscape {
    private var isDown = false
    private var isReported = false
    private val down = mutableSetOf<BrickButton>()

    fun pressed(button: BrickButton, isRunning: Boolean) {
        down += button
        isDown = button == BrickButton.ESCAPE && isRunning && down.size == 1
    }

    /** Whether this is the first time in this run that ESCAPE was pressed and released alone. */
    fun released(button: BrickButton, isRunning: Boolean): Boolean {
        down -= button
        val isAlone = button == BrickButton.ESCAPE && isDown && isRunning && !isReported
        if (button == BrickButton.ESCAPE) isDown = false
        if (isAlone) isReported = true
        return isAlone
    }

    /** Called when a run begins. */
    fun forget() {
        isReported = false
        isDown = false
    }
}
