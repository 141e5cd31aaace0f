package robotran.projects

/** The keywords for session inputs in a project file, and the fields of each kind in addition to its time. */
internal object InputKind {
    const val PRESS = "press"
    const val RELEASE = "release"
    const val STOP = "stop"
    const val PLACE_ROBOT = "placeRobot"
    const val PLACE_BLOCK = "placeBlock"
    const val MOVE_LAMP = "moveLamp"
    const val SWITCH_LAMP = "switchLamp"
    const val LIGHT = "light"
    const val TEMPERATURE = "temperature"
    const val TOUCH = "touch"

    val COMMON = setOf("at", "kind")

    val FIELDS: Map<String, Set<String>> = mapOf(
        PRESS to setOf("button", "robot"),
        RELEASE to setOf("button", "robot"),
        STOP to emptySet(),
        PLACE_ROBOT to setOf("robot", "x", "y", "heading"),
        PLACE_BLOCK to setOf("block", "x", "y", "heading"),
        MOVE_LAMP to setOf("lamp", "x", "y"),
        SWITCH_LAMP to setOf("lamp", "on"),
        LIGHT to setOf("light"),
        TEMPERATURE to setOf("celsius"),
        TOUCH to setOf("robot", "port", "pressed"),
    )
}
