package robotran.rcxrom

import robotran.brick.controls.BrickButton

internal fun RcxBrick.push(button: BrickButton) {
    press(button)
    release(button)
}

internal fun RcxBrick.tick(milliseconds: Int) = repeat(milliseconds) { tick() }
