package robotran.narration

/**
 * A thing of a world as sentences name it.
 *
 * @property name null if it has none.
 */
internal data class Thing(val kind: ThingKind, val name: String? = null)

/** What stops a robot or shines, and the edge of the sheet. */
internal enum class ThingKind { WALL, BARRIER, BLOCK, ROBOT, LAMP, EDGE }

/** A side of a robot. */
internal enum class RobotSide(val degrees: Double) { AHEAD(0.0), LEFT(90.0), RIGHT(-90.0), BEHIND(180.0) }

/** A direction on the sheet, as it lies before the pupil. */
internal enum class SheetSide(val degrees: Double) { RIGHT(0.0), UP(90.0), LEFT(180.0), DOWN(-90.0) }

/** What is on the sheet at a spot. */
internal enum class GroundKind { LINE, AREA, PICTURE, INK, TEMPLATE, TARGET, FORBIDDEN, PERMITTED, PAPER, TABLE }

/** How a mark looks. */
internal enum class Tone { BLACK, GREY, WHITE, RED, YELLOW, GREEN, BLUE }
