package robotran.cli.console

import robotran.simulation.picture.WorldPictures

/** What the desktop app adds to the command line. It should load nothing of the screen before it is asked for. */
interface DesktopApp {
    val pictures: WorldPictures

    /** Opens the window on [files] and returns once it is closed. */
    fun openWindow(files: List<String>): ExitCode
}
