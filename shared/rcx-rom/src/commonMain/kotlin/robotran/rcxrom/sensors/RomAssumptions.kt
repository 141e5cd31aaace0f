package robotran.rcxrom.sensors

/** Decisions where no source is certain; `docs/rcx.md` gives the evidence for each. */
internal object RomAssumptions {
    /**
     * Readings after a counted edge in which the ROM ignores further edges: three tenths of a second. Source:
     * brickEmu's ROM re-implementation, where this part is not finished.
     */
    const val EDGE_DEBOUNCE_READINGS = 100

    /**
     * The lowest raw value that is false without a slope. LEGO's papers say 55 percent, which is 562 or 563. Source:
     * brickEmu.
     */
    const val FALSE_FROM = 564

    /**
     * Where the ROM stores the positions of rotation sensors. Source: leJOS's linker script; brickEmu says 0xEF35,
     * which edge counting needs.
     */
    const val ANGLE_STATES = 0xEF32
}
