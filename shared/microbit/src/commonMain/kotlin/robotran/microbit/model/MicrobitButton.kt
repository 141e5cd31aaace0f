package robotran.microbit.model

import robotran.brick.controls.BrickButton

/**
 * What a finger can press on a micro:bit.
 *
 * @property control the same among the buttons of all bricks.
 * @property python what MicroPython asks about it.
 */
enum class MicrobitButton(val control: BrickButton, val python: String) {
    /** The left one; it starts the program. */
    A(BrickButton.ENTER, "button_a.is_pressed()"),
    B(BrickButton.RIGHT, "button_b.is_pressed()"),

    /** The golden logo of a V2, which feels a touch. */
    LOGO(BrickButton.ESCAPE, "pin_logo.is_touched()"),
}
