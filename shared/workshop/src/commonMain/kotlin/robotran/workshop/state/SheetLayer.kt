package robotran.workshop.state

/** What is drawn over the plain sheet on demand. */
enum class SheetLayer {
    /** Where sensors look, what they measure, and what bumpers touch. */
    SENSORS,

    /** Where the robots have driven. */
    TRAIL,

    /** What robots, blocks, barriers, lamps and marks are called. */
    NAMES,

    /** A line every ten centimetres, and closer to every one. */
    GRID,

    /** The regions that goals are about. */
    GOALS,
    ;

    companion object {
        /** What is drawn unless somebody wants it otherwise. */
        val DEFAULT: Set<SheetLayer> = setOf(GOALS)
    }
}
