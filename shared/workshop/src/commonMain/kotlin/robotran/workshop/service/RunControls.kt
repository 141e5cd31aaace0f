package robotran.workshop.service

interface RunControls {
    /** Starts the current program on an empty sheet, like Run in the run bar. */
    fun run()
}
