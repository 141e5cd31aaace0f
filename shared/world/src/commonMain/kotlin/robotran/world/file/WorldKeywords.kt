package robotran.world.file

import robotran.world.LightFacing
import robotran.world.PortSensor
import robotran.world.RobotColour
import robotran.world.TouchKind

/** The keywords in a file for enum constants: in lower case, with blanks. */
internal val COLOURS: Map<String, RobotColour> = RobotColour.entries.associateBy { wordFor(it) }
val FACINGS: Map<String, LightFacing> = LightFacing.entries.associateBy { wordFor(it) }
internal val SENSORS: Map<String, PortSensor> = PortSensor.entries.associateBy { wordFor(it) }
internal val TOUCH_KINDS: Map<String, TouchKind> = TouchKind.entries.associateBy { wordFor(it) }

internal val PORTS = listOf("1", "2", "3")

/** In lower case, with blanks, such as `left bumper`. */
fun wordFor(constant: Enum<*>): String = constant.name.lowercase().replace('_', ' ')
