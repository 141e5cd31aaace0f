package robotran.cli.messages

/** Messages about robots and their bricks. Names of bricks are `RCX` and `NXT`. */
internal interface RobotMessages {
    /** `--press` names a button that the brick lacks. */
    fun noButton(brick: String, button: String, buttons: List<String>): String

    /** `--rom-log-only` names a group of calls that the brick lacks. */
    fun noCallGroup(brick: String, group: String, groups: List<String>): String

    /** `--memory` needs an RCX. */
    fun noMemory(brick: String): String

    /** The robot with this description, given by `--robot-file`, would start in an obstacle of the world. */
    fun standsIn(robot: String, file: String): String

    /** The file [name] describes a robot without mistakes. */
    fun robotIsFine(name: String, title: String, brick: String): String
}
