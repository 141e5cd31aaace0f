package robotran.workshop.state

/** Optional layers drawn over the sheet. */
enum class SheetLayer {
    /** The sensors' fields of view, their readings, and the contact areas of bumpers. */
    SENSORS,

    /** The paths of the robots. */
    TRAIL,

    /** The names of robots, blocks, barriers, lamps and marks. */
    NAMES,

    /** A line every ten centimetres; zoomed in, every centimetre. */
    GRID,

    /** The regions of goals. */
    GOALS,
    ;

    companion object {
        /** The layers shown by default. */
        val DEFAULT: Set<SheetLayer> = setOf(GOALS)
    }
}
