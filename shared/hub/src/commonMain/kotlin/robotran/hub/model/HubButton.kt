package robotran.hub.model

import robotran.brick.controls.BrickButton

/**
 * The buttons of hubs, as Pybricks names them. On hubs of Powered Up the one in the middle stops a program, on an EV3
 * and an NXT another, which no program sees: [BACK].
 *
 * @property control the same among the buttons of all bricks.
 */
enum class HubButton(val control: BrickButton) {
    LEFT(BrickButton.LEFT),
    RIGHT(BrickButton.RIGHT),
    CENTER(BrickButton.ENTER),
    BLUETOOTH(BrickButton.BLUETOOTH),
    UP(BrickButton.UP),
    DOWN(BrickButton.DOWN),
    BACK(BrickButton.ESCAPE),
}
