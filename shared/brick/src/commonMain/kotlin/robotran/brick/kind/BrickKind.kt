package robotran.brick.kind

/**
 * The kinds of bricks that a robot can have.
 *
 * @property inputPorts number of ports for sensors, numbered from 1 on the brick.
 */
enum class BrickKind(val inputPorts: Int) {
    /** LEGO's brick of 1998, with leJOS. */
    RCX(inputPorts = 3),

    /** LEGO's brick of 2006, with leJOS NXJ. */
    NXT(inputPorts = 4),
}
