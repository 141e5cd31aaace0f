package robotran.workshop.service

import robotran.runcontrol.RecordedRun

/** Starts and reads the run. */
interface RunControls {
    /** Starts the current program on an empty sheet, like Run in the run bar. */
    fun run()

    /** Puts the robots back to their start on an empty sheet, with all goals open, and starts nothing. */
    fun startOver()

    /** Repeats the run with the inputs that the project was opened with, once its programs are compiled. */
    suspend fun playInputs()

    /** The known run, to be repeated elsewhere. */
    fun recordedRun(): RecordedRun
}
