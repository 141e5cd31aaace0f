package robotran.workshop.service

/** Starts programs. */
interface RunControls {
    /** Starts the program that is shown on a clean sheet, as Run in the run bar does. */
    fun run()
}
