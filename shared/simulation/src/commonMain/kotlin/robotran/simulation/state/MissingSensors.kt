package robotran.simulation.state

import robotran.brick.program.RuntimeWarning

/**
 * The sensors that a program expects, but its robot does not have.
 *
 * @property sensors at most one per port, in the order of the ports; not empty.
 * @property warning says it of all of them, with the line that first expects one.
 */
data class MissingSensors(val sensors: List<MissingSensor>, val warning: RuntimeWarning)
