package robotran.rcxrom.program

/** A firmware that a brick can have instead of leJOS's. */
interface RcxFirmware {
    /** Loads it into a brick with these [programs]; see [robotran.rcxrom.RcxBrick]. */
    fun load(programs: List<RcxProgram?>, firstSlot: Int, hardware: ShellHardware): RcxShell
}
