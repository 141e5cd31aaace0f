package robotran.rcxrom.sensors

/** What no source tells for sure, decided here; `docs/rcx.md` says what speaks for each. */
internal object OpenPoints {
    /**
     * After a counted edge the ROM does not look for the next one in so many readings, three tenths of a second.
     * Source: the re-implemented ROM of brickEmu, where this part is not finished.
     */
    const val EDGE_DEBOUNCE_READINGS = 100

    /**
     * The lowest raw value that is false without a slope; LEGO's papers say 55 percent, which is 562 or 563. Source:
     * brickEmu.
     */
    const val FALSE_FROM = 564

    /**
     * Where the ROM keeps the places of rotation sensors. Source: leJOS's linker script; brickEmu says 0xEF35, which
     * edges need.
     */
    const val ANGLE_STATES = 0xEF32
}
