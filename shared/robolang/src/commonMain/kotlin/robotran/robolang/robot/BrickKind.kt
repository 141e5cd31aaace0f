package robotran.robolang.robot

/**
 * The kinds of bricks that a robot can have.
 *
 * @property inputPorts number of ports for sensors, numbered from 1 on the brick.
 */
enum class BrickKind(val inputPorts: Int) { RCX(inputPorts = 3), NXT(inputPorts = 4) }
