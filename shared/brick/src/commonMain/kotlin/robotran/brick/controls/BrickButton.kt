package robotran.brick.controls

/**
 * The buttons of all bricks.
 *
 * @property label what is printed on it or, where nothing is, its name in the brick's own manual.
 */
enum class BrickButton(val label: String) {
    ON_OFF("On-Off"),
    VIEW("View"),
    PRGM("Prgm"),
    RUN("Run"),

    /** The orange button of an NXT, the one in the middle of a hub, and A of a micro:bit. */
    ENTER("Enter"),
    LEFT("Left"),

    /** Also B of a micro:bit. */
    RIGHT("Right"),

    /** The dark grey button of an NXT, the one of an EV3 that goes back, and the logo of a micro:bit. */
    ESCAPE("Escape"),
    BLUETOOTH("Bluetooth"),
    UP("Up"),
    DOWN("Down"),
}
